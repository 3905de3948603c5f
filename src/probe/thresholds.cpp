#include "probe/thresholds.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "probe/sample_points.h"

namespace isomotion::probe {
namespace {

using scene::SurfaceAt;

// Exponents of two.
constexpr int moderate_exponent = 30, largest_exponent = 1000;

struct Sample {
    double value = 0, slope = 0;

    bool is_known() const { return std::isfinite(value) && std::isfinite(slope) && slope > 0; }
    double distance() const { return std::abs(value) / slope; } // to the surface, to first order
};

// Samples of F at points of the bounds, by arithmetic of T.
template<class T>
std::vector<Sample> samples_of(const formula::Field& field, const SurfaceAt& surface) {
    // A large sum makes each sample dear; the median needs few.
    const std::vector<int> counts = surface.bindings.counts();
    const double operations = std::max(formula::cost(field.gradient, counts).operations,
                                       formula::cost(field.value, counts).operations);
    // But a formula at the limits (scene/limits.h) must not keep a scene from being read.
    const double least = std::clamp(6.4e7 / (operations + 1), 2.0, 128.0);
    const int count = int(std::clamp(2e7 / (operations + 1), least, 4096.0));

    // All together: sums over very many elements take a fraction of the time.
    std::array<std::vector<T>, 3> at, gradients;
    std::vector<T> values;
    values.resize(std::size_t(count));
    for (auto& part : gradients) part.resize(std::size_t(count));
    for (int k = 1; k <= count; ++k) {
        const glm::dvec3 p = sample_point(surface.bounds, k);
        for (int axis = 0; axis < 3; ++axis) at[std::size_t(axis)].push_back(T(p[axis]));
    }
    const auto bindings = formula::convert<T>(surface.bindings);
    const std::array<std::span<const T>, 3> from{at[0], at[1], at[2]};
    formula::Evaluator<T>(field.value).points(bindings, from, std::array{std::span(values)});
    formula::Evaluator<T>(field.gradient)
        .points(
            bindings, from,
            std::array{std::span(gradients[0]), std::span(gradients[1]), std::span(gradients[2])});
    std::vector<Sample> samples;
    for (std::size_t k = 0; k < values.size(); ++k) {
        samples.push_back(
            {double(values[k]), std::hypot(double(gradients[0][k]), double(gradients[1][k]),
                                           double(gradients[2][k]))});
    }
    return samples;
}

// Slopes of the samples near the surface, from the least to the largest.
std::vector<double> slopes_near_surface(std::vector<Sample> samples) {
    std::erase_if(samples, [](const Sample& sample) { return !sample.is_known(); });
    const std::size_t eighth =
        std::max(samples.size() / 8, std::min(samples.size(), std::size_t(1)));
    const auto nearest = samples.begin() + std::ptrdiff_t(eighth);
    std::partial_sort(samples.begin(), nearest, samples.end(),
                      [](const Sample& a, const Sample& b) { return a.distance() < b.distance(); });
    std::vector<double> slopes;
    for (auto sample = samples.begin(); sample != nearest; ++sample)
        slopes.push_back(sample->slope);
    std::ranges::sort(slopes);
    return slopes;
}

double power_of_two(int exponent) {
    return std::ldexp(1.0, std::clamp(exponent, -largest_exponent, largest_exponent));
}

// The power of two that F is divided by for moderate slopes, 1 in the median, or 0 where they are
// moderate. Steep powers have slopes of every size: what is large in one place near the surface
// must not be scaled until another place is lost.
int moderated_exponent(std::span<const double> slopes) {
    if (slopes.empty()) return 0;
    const std::size_t tenth = slopes.size() / 10;
    const int median = std::ilogb(slopes[slopes.size() / 2]);
    const int least = std::ilogb(slopes[tenth]);
    const int most = std::ilogb(slopes[slopes.size() - 1 - tenth]);
    const int exponent = median > 0 ? std::clamp(least + moderate_exponent, 0, median)
                                    : std::clamp(most - moderate_exponent, median, 0);
    return std::abs(exponent) <= moderate_exponent ? 0 : exponent;
}

// Samples by floats that come to the values of doubles, unscaled or times `scale`. The others have
// parts that are cut off at 10^30, or underflow, whatever the scale.
std::vector<Sample> samples_that_floats_hold(const formula::Field& field, const SurfaceAt& surface,
                                             double scale) {
    const std::vector<Sample> exact = samples_of<double>(field, surface);
    const std::vector<Sample> unscaled = samples_of<float>(field, surface);
    const std::vector<Sample> scaled = samples_of<float>(formula::scaled(field, scale), surface);
    const auto agree = [](double a, double b) { return std::abs(a - b) <= 0.5 * std::abs(b); };
    std::vector<Sample> held;
    for (std::size_t k = 0; k < exact.size(); ++k) {
        const double value = exact[k].value;
        if (agree(unscaled[k].value, value))
            held.push_back(unscaled[k]);
        else if (agree(scaled[k].value, scale * value))
            held.push_back({value, scaled[k].slope / scale});
    }
    return held;
}

} // namespace

double field_slope(const formula::Field& field, const SurfaceAt& surface) {
    const std::vector<double> slopes = slopes_near_surface(samples_of<double>(field, surface));
    return slopes.empty() ? 0 : slopes[slopes.size() / 2];
}

Thresholds field_thresholds(double slope, double step) {
    // Nothing is known of the field's scale: base steps everywhere.
    if (slope == 0) return {0, 1e30, 0};
    return {2 * step * slope, 8 * step * slope, 0.1 * slope};
}

double field_scale(const formula::Field& field, const SurfaceAt& surface) {
    std::vector<double> slopes = slopes_near_surface(samples_of<double>(field, surface));
    const int exponent = moderated_exponent(slopes);
    if (exponent == 0) return 1;
    slopes = slopes_near_surface(samples_that_floats_hold(field, surface, power_of_two(-exponent)));
    return power_of_two(-moderated_exponent(slopes)); // 1 if no scale makes floats hold F
}

Float32Loss float32_loss(const formula::Field& field, const SurfaceAt& surface) {
    const std::vector<Sample> in_floats = samples_of<float>(field, surface);
    const std::vector<Sample> in_doubles = samples_of<double>(field, surface);
    Float32Loss loss;
    std::size_t values = 0, lost = 0;
    for (std::size_t k = 0; k < in_floats.size(); ++k) {
        const double exact = in_doubles[k].value;
        if (!std::isfinite(exact) || exact == 0) continue;
        ++values;
        const bool overflows =
            !std::isfinite(in_floats[k].value) ||
            (!std::isfinite(in_floats[k].slope) && std::isfinite(in_doubles[k].slope));
        // What underflows on the way is 0 at the end, whatever F is scaled by; but so is what
        // cancels.
        const double least = in_floats[k].value == 0 ? field.scale : 1;
        const bool underflows = std::abs(exact) < double(FLT_MIN) * std::max(least, 1.0);
        if (!overflows && !underflows) continue;
        ++lost;
        loss.example = exact / field.scale;
    }
    loss.part = values > 0 ? double(lost) / double(values) : 0;
    return loss;
}

double float32_displacement(const formula::Field& field, const SurfaceAt& surface) {
    const std::vector<Sample> in_floats = samples_of<float>(field, surface);
    const std::vector<Sample> in_doubles = samples_of<double>(field, surface);
    std::vector<std::pair<double, double>> near; // distance from the surface, displacement
    for (std::size_t k = 0; k < in_doubles.size(); ++k) {
        const Sample& exact = in_doubles[k];
        if (!exact.is_known()) continue;
        const double off = std::abs(in_floats[k].value - exact.value) / exact.slope;
        near.emplace_back(exact.distance(), std::isnan(off) ? HUGE_VAL : off);
    }
    if (near.empty()) return HUGE_VAL;
    std::ranges::sort(near);
    near.resize(std::max<std::size_t>(near.size() / 8, 1));
    const auto middle = near.begin() + std::ptrdiff_t(near.size() / 2);
    std::ranges::nth_element(near, middle, {}, &std::pair<double, double>::second);
    return middle->second / surface.bounds.radius;
}

bool is_far(const scene::BoundsAt& bounds) {
    const glm::dvec3 away = glm::abs(bounds.centre);
    return std::max({away.x, away.y, away.z}) > far_radii * bounds.radius;
}

} // namespace isomotion::probe
