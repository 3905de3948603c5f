// Adds up the GPU's time for draws of beams and rays. What the driver waits for between them, such
// as the count of rays that go on, is not in it.
#pragma once

#include <chrono>
#include <utility>

#include "gpu/query.h"

namespace isomotion::render {

class RayClock {
public:
    // Runs these draws and waits for their time.
    template<typename Draws> void time(const Draws& draws) {
        timer_.begin();
        draws();
        timer_.end();
        sum_ += std::chrono::nanoseconds(timer_.nanoseconds());
    }

    // The time since the last call.
    std::chrono::nanoseconds take() { return std::exchange(sum_, {}); }

private:
    gpu::Timer timer_;
    std::chrono::nanoseconds sum_{};
};

} // namespace isomotion::render
