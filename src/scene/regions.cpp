#include "scene/regions.h"

#include <algorithm>

#include "scene/error.h"

namespace isomotion::scene {
namespace {

using formula::Interval, formula::Region;

constexpr int most_frames = 17;
constexpr double dear_frame = 1e6; // operations of the arrays' fields

Region region_of(const SceneAt& now) {
    const glm::dvec3 &low = now.bounds.min, &high = now.bounds.max;
    return {formula::convert<Interval>(now.bindings),
            {Interval{low.x, high.x}, Interval{low.y, high.y}, Interval{low.z, high.z}}};
}

void cover(Interval& a, const Interval& b) { a = hull(a, b); }

// Elements are taken one with the other where there are as many.
void cover(Region& region, const Region& other) {
    for (std::size_t k = 0; k < 3; ++k) cover(region.box[k], other.box[k]);
    auto &mine = region.bindings;
    const auto& theirs = other.bindings;
    for (std::size_t k = 0; k < mine.parameters.size(); ++k)
        cover(mine.parameters[k], theirs.parameters[k]);
    for (std::size_t a = 0; a < mine.arrays.size(); ++a) {
        if (mine.arrays[a].count != theirs.arrays[a].count) continue;
        for (std::size_t f = 0; f < mine.arrays[a].fields.size(); ++f) {
            auto& field = mine.arrays[a].fields[f];
            for (std::size_t e = 0; e < field.size(); ++e)
                cover(field[e], theirs.arrays[a].fields[f][e]);
        }
    }
}

int frames_to_look_at(const Scene& scene) {
    double operations = 0;
    for (std::size_t a = 0; a < scene.timeline.animation.arrays().size(); ++a)
        operations += scene.timeline.animation.operations(a);
    const double most = dear_frame / (operations + 1);
    return std::clamp(int(std::min(most, double(most_frames))), 1, scene.timeline.frames);
}

} // namespace

std::vector<Region> regions(const Scene& scene, const SceneAt& first) {
    std::vector<Region> at_frames{region_of(first)};
    const int count = frames_to_look_at(scene);
    for (int k = 1; k < count; ++k) {
        const int frame =
            1 + int(std::int64_t(scene.timeline.frames - 1) * k / std::max(1, count - 1));
        try {
            at_frames.push_back(region_of(at(scene, scene.timeline.values(frame))));
        } catch (const SceneError&) { // said where the frame is drawn
        }
    }
    if (at_frames.size() == 1) return at_frames;
    for (std::size_t k = 0; k + 1 < at_frames.size(); ++k) cover(at_frames[k], at_frames[k + 1]);
    at_frames.pop_back();
    return at_frames;
}

} // namespace isomotion::scene
