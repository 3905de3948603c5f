// How far a frame is, of those that take long: Progress counts whole ones.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "app/progress.h"
#include "sequence/exporter.h"

namespace isomotion::app {

// What is said of a frame of which `part` is drawn after so long: an estimate where it will take
// over a minute in all, none before ten seconds; that nothing is done yet after a minute.
std::optional<std::string> long_frame(int frame, std::chrono::duration<double> passed, double part);

class FrameProgress {
public:
    explicit FrameProgress(Progress& progress)
        : progress_(progress) {}

    // Says once a sequence how long its frames take, in a log as on a terminal.
    void show(const sequence::ExportProgress& now);

private:
    using Clock = std::chrono::steady_clock;

    Progress& progress_;
    int done_ = -1;
    Clock::time_point begin_{}, shown_{}; // of the frame, and of what the line says
    bool told_ = false;
};

} // namespace isomotion::app
