// Progress within a frame, and a word on frames that take long.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include "app/progress.h"
#include "isomotion/sequence.h"

namespace isomotion::app {

// The message on a frame. It is an estimate if the frame will take over ten seconds, and says that
// nothing is done yet after ten. None in the first two.
std::optional<std::string> long_frame(const ExportProgress& now, const std::string& costs);

class FrameProgress {
public:
    FrameProgress(Progress& progress, std::string costs)
        : progress_(progress)
        , costs_(std::move(costs)) {}

    // Reports once per sequence how long its frames take, in a log as on a terminal.
    void show(const ExportProgress& now);

private:
    using Clock = std::chrono::steady_clock;

    Progress& progress_;
    std::string costs_;
    int done_ = -1;
    Clock::time_point shown_{};
    bool told_ = false;
};

} // namespace isomotion::app
