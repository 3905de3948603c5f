// Progress within a frame that takes long; Progress counts whole frames.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "app/progress.h"
#include "sequence/exporter.h"

namespace isomotion::app {

// The message on a frame of which `part` is drawn after the time `passed`. It is an estimate if the
// frame will take over a minute in total, and says that nothing is done yet after a minute. None
// before ten seconds.
std::optional<std::string> long_frame(int frame, std::chrono::duration<double> passed, double part);

class FrameProgress {
public:
    explicit FrameProgress(Progress& progress)
        : progress_(progress) {}

    // Reports once per sequence how long its frames take, in a log as on a terminal.
    void show(const sequence::ExportProgress& now);

private:
    using Clock = std::chrono::steady_clock;

    Progress& progress_;
    int done_ = -1;
    Clock::time_point begin_{}, shown_{}; // of the frame, and of the text shown
    bool told_ = false;
};

} // namespace isomotion::app
