// How far a frame is, of those that take long: Progress counts whole ones.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "app/progress.h"

namespace isomotion::app {

// What is said of a frame of which `part` is drawn after so long: an estimate where it will take
// over a minute in all, none before ten seconds; that nothing is done yet after a minute.
std::optional<std::string> long_frame(int frame, std::chrono::duration<double> passed, double part);

class FrameProgress {
public:
    FrameProgress(Progress& progress, int pictures) // of a frame, whose mean it is
        : progress_(progress)
        , pictures_(pictures) {}

    // `done` frames are finished, and `frame` is the next, of this name.
    void begin(int done, int frame, std::string name);
    // Told by a renderer, picture by picture of the frame: so much of it is drawn. Says once a
    // sequence how long its frames take, in a log as on a terminal.
    void at(double part);

private:
    using Clock = std::chrono::steady_clock;

    Progress& progress_;
    int pictures_, picture_ = 0;
    int done_ = 0, frame_ = 0;
    std::string name_;
    double part_ = 0; // of the picture
    Clock::time_point begin_{}, shown_{};
    bool told_ = false;
};

} // namespace isomotion::app
