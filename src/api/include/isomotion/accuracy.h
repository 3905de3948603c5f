// What methods cost, and which pixels they get wrong: compared with certified truth.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <isomotion/drawing.h>

namespace isomotion {

struct AccuracySettings {
    std::vector<int> frames = {};          // empty: the scene's poster
    std::vector<std::string> methods = {}; // empty: all that can draw the scene
    std::vector<double> steps = {};        // empty: the scene's times 4 and 2, down to 1/8 of it
    int repeat = 3;                        // how often each frame is drawn
    std::string stage = "fragment";        // as of a Renderer
    bool remember = false; // keep truth in the user's cache folder: the next time takes less
    std::filesystem::path output = {}; // the folder of Accuracy::write()
};

// One method with its settings.
struct Measurement {
    std::string name; // "amp-sign step=0.015"
    std::string method;
    double step = 0, thresholds = 1, safety = 0; // thresholds: factor on near, far and horizon
    int bisections = 0;

    double ms = 0, spread = 0; // of a frame: the median, and the range over it
    double evaluations_a_ray = 0, ns_an_evaluation = 0;
    std::int64_t pixels = 0;                                  // of all frames
    std::int64_t missed = 0, false_hits = 0, wrong_roots = 0; // pixels that are certainly wrong
    std::int64_t undecided = 0;                               // by truth
    std::int64_t not_numbers = 0, step_limits = 0;
    std::int64_t pops = 0; // pixels hit or missed for one frame alone, while truth stays the same
    struct Quantiles {
        double median = 0, p99 = 0, largest = 0;
    };
    // Of hits: along the ray in widths of a pixel, of the normal in degrees.
    Quantiles depth_error = {}, normal_error = {};
    // With isolation.certify: the part of pixels that is proved, and the proofs that truth refutes.
    double proved = 0;
    std::int64_t contradicted = 0;
    bool is_on_front = false; // no other is both faster and right more often

    double wrong_ppm() const;
};

class Accuracy {
public:
    const std::vector<Measurement>& measurements() const;
    // The cheapest with at most so many wrong pixels in a million, and the most accurate one that
    // takes at most so long a frame; null: none.
    const Measurement* cheapest(double most_wrong_ppm) const;
    const Measurement* most_accurate(double most_ms) const;

    std::string summary() const; // a table for people
    // Writes accuracy.csv, accuracy.json, pictures of wrong pixels, a plot (by gnuplot) and
    // index.html with all of these into the settings' output.
    void write() const;

    struct Parts; // for isomotion itself
    explicit Accuracy(std::shared_ptr<const Parts> parts);

private:
    std::shared_ptr<const Parts> parts_;
};

// The names of what accuracy_of() measures. Throws for all that can be foreseen to fail before
// there is a Device: a method that cannot draw the scene, an output that would replace a file that
// the scene is read from, a value that leaves its range at some frame.
std::vector<std::string> accuracy_plan(const Scene& scene, const AccuracySettings& settings = {});
// In pictures of the scene's size.
Accuracy accuracy_of(Device& device, const Scene& scene, const AccuracySettings& settings = {},
                     const Watcher& watcher = {});

struct ChoiceSettings {
    double most_wrong_ppm = 0;
    std::vector<int> frames = {}; // up to three of them are measured; empty: the scene's poster
    bool keep_method = false;     // choose its step alone
    std::string stage = "fragment";
    bool remember = false; // as above
};

struct Choice {
    std::optional<Scene> scene; // with the chosen methods; none: no setting is that accurate
    std::string summary;        // lines for people: what is chosen, in place of what
};

// Chooses the cheapest method and step, in pictures of at most 256 pixels a side. Each of several
// surfaces is measured alone and gets as large a part of the wrong pixels; then all are measured
// together.
Choice choose_methods(Device& device, const Scene& scene, const ChoiceSettings& settings,
                      const Watcher& watcher = {});

// The names of the effects that a scene calls for.
std::vector<std::string> effects_of(const Scene& scene);

struct EffectPrice {
    std::string effect;
    double with = 0, without = 0; // ms a frame, medians
    double price = 0;             // ms: the median of the differences of paired drawings
};

std::vector<EffectPrice> effect_prices(Device& device, const Scene& scene, int frame,
                                       int repeat = 3, const std::string& stage = "fragment");

} // namespace isomotion
