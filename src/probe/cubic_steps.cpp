#include "probe/cubic_steps.h"

#include <algorithm>
#include <set>
#include <vector>

#include "scene/error.h"

namespace isomotion::probe {
namespace {

using scene::OneSurface, scene::SceneError, scene::SurfaceAt;

// The most frames looked at, evenly apart; the same where arrays move; and the most among
// which the extremes of parameters are looked for.
constexpr int most_even = 9, most_of_arrays = 3, most_sampled = 1000;
constexpr int most_extreme = 8;              // parameters of which extremes are looked for
constexpr double operations_of_frames = 3e6; // of tracks and arrays, at all frames

std::set<int> even_frames(const OneSurface& one, int count) {
    std::set<int> frames;
    for (int k = 0; k < count; ++k)
        frames.insert(
            1 + int(std::int64_t(one.scene.timeline.frames - 1) * k / std::max(1, count - 1)));
    return frames;
}

// The frames at which a parameter is least or largest.
std::set<int> extreme_frames(const OneSurface& one, const std::set<int>& among) {
    struct Extreme {
        double value;
        int frame;
    };
    const int count = std::min(one.surface.parameters, most_extreme);
    std::vector<Extreme> least, largest;
    for (const int frame : among) {
        const animation::Values values = one.surface.animation.at(one.scene.timeline.time(frame));
        for (int k = 0; k < count; ++k) {
            const Extreme now{values.tracks[std::size_t(k)], frame};
            if (int(least.size()) == k) {
                least.push_back(now);
                largest.push_back(now);
            }
            if (now.value < least[std::size_t(k)].value) least[std::size_t(k)] = now;
            if (now.value > largest[std::size_t(k)].value) largest[std::size_t(k)] = now;
        }
    }
    std::set<int> frames;
    for (const Extreme& extreme : least) frames.insert(extreme.frame);
    for (const Extreme& extreme : largest) frames.insert(extreme.frame);
    return frames;
}

std::set<int> telling_frames(const OneSurface& one) {
    const animation::Animation& moves = one.surface.animation;
    double operations = moves.operations() + 1;
    for (std::size_t a = 0; a < moves.arrays().size(); ++a) operations += moves.operations(a);
    const auto affordable = [&](int most) {
        return std::clamp(int(std::min(operations_of_frames / operations, double(most))), 1,
                          one.scene.timeline.frames);
    };
    const bool is_plain =
        std::ranges::all_of(moves.arrays(), &animation::Array::is_of_formula); // which rest
    std::set<int> frames = even_frames(one, affordable(is_plain ? most_even : most_of_arrays));
    if (is_plain) frames.merge(extreme_frames(one, even_frames(one, affordable(most_sampled))));
    return frames;
}

formula::Moment moment_of(const SurfaceAt& now) {
    const glm::dvec3 &low = now.bounds.min, &high = now.bounds.max;
    return {formula::convert<double>(now.bindings),
            {formula::Interval{low.x, high.x}, {low.y, high.y}, {low.z, high.z}}};
}

} // namespace

formula::CubicSteps cubic_steps(const OneSurface& one, const formula::Smoothness& smoothness,
                                const SurfaceAt& first) {
    std::vector<formula::Moment> moments{moment_of(first)};
    for (const int frame : telling_frames(one)) {
        if (frame == 1) continue;
        try {
            moments.push_back(moment_of(surface_at(one, one.scene.timeline.time(frame))));
        } catch (const SceneError&) { // said where the frame is drawn
        }
    }
    return formula::cubic_steps(*one.surface.field, smoothness, moments,
                                0.125 * first.bounds.radius, one.surface.isolation.safety);
}

} // namespace isomotion::probe
