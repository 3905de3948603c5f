#pragma once

#include "gpu/name.h"

#include <chrono>
#include <cstdint>

namespace isomotion::gpu {

/// How many pixels were drawn between begin() and end().
class SamplesQuery {
public:
    void begin();
    void end();

    /// True once passed() would not have to wait.
    bool ready() const;
    std::uint32_t passed() const;

private:
    Name name_{Kind::query};
};

/// Time that the GPU spent between begin() and end(). One at a time: timers do not nest.
///
/// On software drivers it is the clock on the wall between two points where all drawing is done:
/// llvmpipe's GL_TIME_ELAPSED and GL_TIMESTAMP cover only one tile of 64 x 64 pixels (3 ms of a
/// draw that takes 100), and after a shader's first draw the time since the machine was started.
class Timer {
public:
    Timer();

    void begin();
    void end();

    /// True once nanoseconds() would not have to wait.
    bool ready() const;
    std::uint64_t nanoseconds() const;

private:
    using Clock = std::chrono::steady_clock;

    Name name_{Kind::query};
    bool on_the_wall_;
    Clock::time_point begun_{}, ended_{};
};

} // namespace isomotion::gpu
