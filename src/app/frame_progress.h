// Progress within a frame, and a word on frames that take long.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "app/progress.h"
#include "scene/scene.h"
#include "sequence/exporter.h"

namespace isomotion::app {

// What makes a scene's frames take long, and what to set for less: "16 samples a pixel (--set
// output.samples=1), glass 6 rays deep (material.glass.depth), 512x512 pixels (--size)".
std::string what_costs(const scene::Scene& scene);

// How long the rest of a frame will take, after the time `passed`. Its first two parts may compile
// shaders, so later ones tell the pace; before the third, nobody knows it.
class Pace {
public:
    using Seconds = std::chrono::duration<double>;

    // `part` of the frame is drawn after the time `passed`. Parts rise.
    void note(double part, Seconds passed);
    std::optional<Seconds> left(Seconds passed) const;

private:
    int compiling_ = 2; // parts yet
    double begin_ = 0, part_ = 0;
    Seconds at_begin_{}, at_part_{};
};

// The message on a frame of which `part` is drawn after the time `passed`. It is an estimate if the
// frame will take over ten seconds, and says that nothing is done yet after ten. None in the first
// two.
std::optional<std::string> long_frame(int frame, Pace::Seconds passed, double part,
                                      std::optional<Pace::Seconds> left, const std::string& costs);

class FrameProgress {
public:
    FrameProgress(Progress& progress, const scene::Scene& scene)
        : progress_(progress)
        , costs_(what_costs(scene)) {}

    // Reports once per sequence how long its frames take, in a log as on a terminal.
    void show(const sequence::ExportProgress& now);

private:
    using Clock = std::chrono::steady_clock;

    Progress& progress_;
    std::string costs_;
    int done_ = -1;
    Clock::time_point begin_{}, shown_{}; // of the frame, and of the text shown
    Pace pace_;                           // of the frame
    bool told_ = false;
};

} // namespace isomotion::app
