#pragma once

#include "gpu/name.h"

#include <chrono>
#include <cstdint>

namespace isomotion::gpu {

/// Counts the pixels drawn between begin() and end().
class SamplesQuery {
public:
    void begin();
    void end();

    /// True if passed() would not wait.
    bool ready() const;
    std::uint32_t passed() const;

private:
    Name name_{Kind::query};
};

/// Measures the GPU's time between begin() and end(). Use one at a time: timers do not nest.
///
/// On software drivers it measures wall time between two points at which all drawing is finished.
/// There llvmpipe's GL_TIME_ELAPSED and GL_TIMESTAMP cover only one tile of 64 x 64 pixels (3 ms of
/// a draw that takes 100), and after a shader's first draw the time since the machine was started.
class Timer {
public:
    Timer();

    void begin();
    void end();

    /// True if nanoseconds() would not wait.
    bool ready() const;
    std::uint64_t nanoseconds() const;

private:
    using Clock = std::chrono::steady_clock;

    Name name_{Kind::query};
    bool on_the_wall_;
    Clock::time_point begun_{}, ended_{};
};

} // namespace isomotion::gpu
