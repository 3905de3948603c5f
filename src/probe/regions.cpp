#include "probe/regions.h"

#include <algorithm>

#include "scene/error.h"

namespace isomotion::probe {
namespace {

using scene::OneSurface, scene::SceneError, scene::SurfaceAt;

using formula::Interval, formula::Region;

constexpr int most_frames = 17;
// Operations of the arrays' fields, and as many as those of the formula at a point are counted as.
constexpr double dear_frame = 3e6, dear_point = 1000;

Region region_of(const SurfaceAt& now) {
    const glm::dvec3 &low = now.bounds.min, &high = now.bounds.max;
    return {formula::convert<Interval>(now.bindings),
            {Interval{low.x, high.x}, Interval{low.y, high.y}, Interval{low.z, high.z}}};
}

void cover(Interval& a, const Interval& b) { a = hull(a, b); }

// Elements stay where they are: the hull of one's way may hold all others.
void cover(Region& region, const Region& other) {
    for (std::size_t k = 0; k < 3; ++k) cover(region.box[k], other.box[k]);
    auto& mine = region.bindings.parameters;
    const auto& theirs = other.bindings.parameters;
    for (std::size_t k = 0; k < mine.size(); ++k) cover(mine[k], theirs[k]);
}

int frames_to_look_at(const OneSurface& one, const SurfaceAt& first) {
    double operations = 0;
    for (std::size_t a = 0; a < one.surface.animation.arrays().size(); ++a)
        operations += one.surface.animation.operations(a);
    const std::vector<int> counts = first.bindings.counts();
    operations += dear_point * formula::cost(one.surface.field->value, counts).operations;
    const double most = dear_frame / (operations + 1);
    return std::clamp(int(std::min(most, double(most_frames))), 1, one.scene.timeline.frames);
}

} // namespace

std::vector<Region> regions(const OneSurface& one, const SurfaceAt& first) {
    std::vector<Region> at_frames{region_of(first)};
    const int count = frames_to_look_at(one, first);
    for (int k = 1; k < count; ++k) {
        const int frame =
            1 + int(std::int64_t(one.scene.timeline.frames - 1) * k / std::max(1, count - 1));
        try {
            at_frames.push_back(region_of(surface_at(one, one.scene.timeline.time(frame))));
        } catch (const SceneError&) { // said where the frame is drawn
        }
    }
    if (at_frames.size() == 1) return at_frames;
    for (std::size_t k = 0; k + 1 < at_frames.size(); ++k) cover(at_frames[k], at_frames[k + 1]);
    at_frames.pop_back();
    return at_frames;
}

} // namespace isomotion::probe
