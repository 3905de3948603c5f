// Measures the cost of a setting and the number of pixels that it gets wrong.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "accuracy/compare.h"
#include "accuracy/popping.h"
#include "accuracy/setting.h"

namespace isomotion::accuracy {

struct Measurement {
    Setting setting;
    double ms = 0;          // per frame: the median over frames and repetitions
    double spread = 0;      // their range over the median
    double evaluations = 0; // of the field, per frame
    Errors errors;          // of all frames; the faults are those of the first
    std::int64_t pops = 0;  // see popping.h

    double evaluations_a_ray() const;
    double ns_an_evaluation() const { return 1e6 * ms / evaluations; }
};

struct MeasureOptions {
    std::vector<int> frames{1};
    int width = 0, height = 0;
    int repeat = 3;
    render::StageChoice stage = render::StageChoice::fragment;
    std::filesystem::path cache; // for truth, see truth_cache.h; empty for none
    std::function<void(const std::string& what, double part)> progress;
};

// Certifies the frames once, then draws them with every setting.
std::vector<Measurement> measure(gpu::Context& context, const scene::Scene& scene,
                                 const std::vector<Setting>& settings, const MeasureOptions& how);

// The measurements that no other beats in both time and wrong pixels, from the fastest to the most
// accurate.
std::vector<std::size_t> front(const std::vector<Measurement>& measurements);

// The cheapest measurement of the front with at most so many wrong pixels in a million; the most
// accurate one with at most so much time per frame. Empty if there is none.
std::optional<std::size_t> cheapest(const std::vector<Measurement>& measurements,
                                    double most_wrong_ppm);
std::optional<std::size_t> most_accurate(const std::vector<Measurement>& measurements,
                                         double most_ms);

} // namespace isomotion::accuracy
