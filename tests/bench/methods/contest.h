// Compares methods on one subject: wrong pixels and time.
//
// The sign test with adaptive steps (amp-sign) is the measure. Beside its time at the scene's own
// step stands its time at *equal accuracy*: its step is halved until no more pixels are wrong than
// the other method's.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "accuracy/compare.h"
#include "accuracy/setting.h"
#include "gpu/context.h"
#include "methods/subject.h"

namespace isomotion::bench {

// A subject at a size, with what is certain of each of its frames.
struct Certified {
    Subject subject; // output of the size
    std::vector<scene::SceneAt> frames;
    std::vector<roots::Truth> truths; // empty where only time is asked for

    int width() const { return subject.scene.output.width; }
    int height() const { return subject.scene.output.height; }
};

using Progress = std::function<void(double part)>;

// An empty cache (see truth_cache.h) remembers nothing.
Certified certified(Subject subject, int size, const std::filesystem::path& cache,
                    const Progress& progress = {});
Certified uncertified(Subject subject, int size);

// What a setting does, without any clock.
struct Count {
    accuracy::Errors errors; // of all frames; no values by pixel
    double evaluations = 0;  // of the field, all frames

    double evaluations_a_ray() const { return evaluations / double(errors.rays); }
    double ppm(std::int64_t pixels) const { return 1e6 * double(pixels) / double(errors.pixels); }
};
Count count(gpu::Context& context, const Certified& on, const accuracy::Setting& setting);

// Pixels that meet the bounds, in all frames.
std::int64_t rays(const Certified& on);

// Operations that an evaluation of the field takes with this method, a transcendental function or a
// division counted as one.
double operations(const scene::Scene& scene, scene::Method method);

struct Timing {
    std::string refused;        // why there is no time: the method can't draw this
    double ms = 0;              // of a frame: the mean over the frames of medians over the rounds
    double spread = 0;          // largest range over the median of a frame
    double evaluations = 0;     // of the field, all frames
    std::vector<double> rounds; // ms of all frames, round by round
};

// How many times as long `slow` takes as `fast` in the same race: the median over the rounds, in
// each of which both met the same load of the machine.
double ratio(const Timing& slow, const Timing& fast);

// Who draws in a race, with as many frames as all others.
struct Entrant {
    const Certified* on;
    accuracy::Setting setting;
};

// All entrants in turn, round by round, each round begun by another: what else the machine does
// then weighs on all alike. Rounds are fewer where `repeat` of them would take more than a minute.
std::vector<Timing> race(gpu::Context& context, std::span<const Entrant> entrants, int repeat);

// The same picture with its bounds out of sight: the time of its frame is what remains to a method
// that finds roots for nothing.
Certified without_bounds(const Certified& on);

struct Standing {
    scene::Method method;
    std::string refused; // why the method is out; then nothing else is known
    Count count;
    Timing timing;
    double operations = 0;    // a second, of the field
    double against_own = 0;   // time of the sign test at the scene's step over this method's
    int halvings = 0;         // of the sign test's step, for equal accuracy
    bool reached = false;     // else the sign test gets more pixels wrong even then
    double against_equal = 0; // time of the sign test at that step over this method's
    double at_most = 0;       // and over that of the empty frame
};

struct Contest {
    std::string subject;
    int size = 0, frames = 0;
    double step = 0;
    Timing empty;                    // of the picture without a ray to march
    std::vector<Standing> standings; // in the order of the methods asked for
};

Contest hold(gpu::Context& context, const Certified& on, std::span<const scene::Method> methods,
             int most_halvings, int repeat);

} // namespace isomotion::bench
