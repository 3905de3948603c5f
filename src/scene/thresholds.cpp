#include "scene/thresholds.h"

#include <algorithm>
#include <cmath>

namespace isomotion::scene {
namespace {

// Halton's low-discrepancy sequence: the same points on every machine.
double halton(int index, int base) {
    double result = 0, weight = 1;
    for (; index > 0; index /= base) {
        weight /= base;
        result += weight * (index % base);
    }
    return result;
}

} // namespace

Thresholds field_thresholds(const formula::Field& field, const SceneAt& scene, double step) {
    // A large sum makes each sample dear; the median needs few.
    std::vector<int> counts;
    for (const auto& array : scene.bindings.arrays) counts.push_back(array.count);
    const double operations = formula::cost(field.gradient, counts).operations;
    // But a formula at the limits (scene/limits.h) must not keep a scene from being read.
    const double least = std::clamp(1.28e8 / (operations + 1), 8.0, 128.0);
    const int samples = int(std::clamp(2e7 / (operations + 1), least, 4096.0));

    formula::FieldEvaluator<double> evaluate(field);
    const auto bindings = formula::convert<double>(scene.bindings);
    struct Sample {
        double distance; // first-order distance to the surface
        double slope;
    };
    std::vector<Sample> found;
    for (int k = 1; k <= samples; ++k) {
        const glm::dvec3 unit(halton(k, 2), halton(k, 3), halton(k, 5));
        const glm::dvec3 p = scene.bounds.min + unit * (scene.bounds.max - scene.bounds.min);
        const std::array<double, 3> at{p.x, p.y, p.z};
        const double f = evaluate.value(bindings, at);
        const auto g = evaluate.gradient(bindings, at);
        const double slope = std::hypot(g[0], g[1], g[2]);
        if (std::isfinite(f) && std::isfinite(slope) && slope > 0) {
            found.push_back({std::abs(f) / slope, slope});
        }
    }
    // A field without slope at any sample says nothing of its scale: base steps everywhere.
    if (found.empty()) return {0, 1e30, 0};
    const auto nearest = std::ptrdiff_t(std::max<std::size_t>(1, found.size() / 8));
    std::partial_sort(found.begin(), found.begin() + nearest, found.end(),
                      [](const Sample& a, const Sample& b) { return a.distance < b.distance; });
    const auto middle = found.begin() + nearest / 2;
    std::nth_element(found.begin(), middle, found.begin() + nearest,
                     [](const Sample& a, const Sample& b) { return a.slope < b.slope; });
    const double slope = middle->slope;
    return {2 * step * slope, 8 * step * slope, 0.1 * slope};
}

} // namespace isomotion::scene
