// What animations promise, from their values alone: no GL.
#include <cmath>
#include <set>

#include "gallery/animations.h"
#include "scene/load.h"
#include "scene/scene_at.h"

namespace isomotion::scene {
namespace {

TEST(Promises, EverySurfaceMovesInSomeAnimation) {
    std::set<std::string> moved;
    for (const std::string& name : animation_names()) moved.insert(load(name).surface.name);
    for (const std::string& name : surface_names()) {
        // Other forms of a surface, for comparison, need no animation of their own.
        if (name == "chmutov_14_power" || name == "chmutov_22_power") continue;
        EXPECT_TRUE(moved.count(name)) << name;
    }
}

TEST(Promises, EveryAnimationLastsTwoToSixSeconds) {
    for (const std::string& name : animation_names()) {
        const Scene scene = load(name);
        const double seconds = scene.timeline.time(scene.timeline.frames + 1);
        EXPECT_GE(seconds, 2) << name;
        EXPECT_LE(seconds, 6) << name;
    }
}

// What the formula sees changes, not only the camera.
TEST(Promises, TheSurfaceItselfMoves) {
    for (const std::string& name : animation_names()) {
        const Scene scene = load(name);
        const SceneAt first = at(scene, scene.timeline.values(1));
        bool moves = false;
        for (int frame = 2; frame <= scene.timeline.frames && !moves; ++frame) {
            const SceneAt now = at(scene, scene.timeline.values(frame));
            moves = now.bindings.parameters != first.bindings.parameters;
            for (std::size_t a = 0; a < now.bindings.arrays.size(); ++a) {
                moves = moves || now.bindings.arrays[a].fields != first.bindings.arrays[a].fields;
            }
        }
        EXPECT_TRUE(moves) << name;
    }
}

TEST(Promises, ParametersStayInTheSurfacesRanges) {
    for (const std::string& name : animation_names()) {
        const Scene scene = load(name);
        for (int frame = 1; frame <= scene.timeline.frames; ++frame) {
            const auto values = scene.timeline.values(frame).tracks;
            for (std::size_t k = 0; k < scene.surface.ranges.size(); ++k) {
                ASSERT_TRUE(scene.surface.ranges[k].contains(values[k]))
                    << name << " frame " << frame << ": "
                    << scene.timeline.animation.tracks()[k].name << " = " << values[k];
            }
        }
    }
}

// Everything that a picture depends on, in one list.
std::vector<double> seen(const Scene& scene, int frame) {
    const SceneAt now = at(scene, scene.timeline.values(frame));
    std::vector<double> all(now.bindings.parameters.begin(), now.bindings.parameters.end());
    for (const auto& array : now.bindings.arrays) {
        for (const auto& field : array.fields) all.insert(all.end(), field.begin(), field.end());
    }
    const auto add = [&](const glm::dvec3& v) { all.insert(all.end(), {v.x, v.y, v.z}); };
    for (const auto& v : {now.bounds.min, now.bounds.max, now.camera.position, now.camera.target,
                          now.camera.up, now.placement.translate, now.placement.rotate[0],
                          now.placement.rotate[1], now.material_color, now.inside_color}) {
        add(v);
    }
    for (const auto& light : now.lights) {
        add(light.direction);
        add(light.color);
    }
    all.insert(all.end(), {now.camera.fov, now.camera.height, now.camera.zoom});
    return all;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
    double square = 0;
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
        square += (a[k] - b[k]) * (a[k] - b[k]);
    }
    return std::sqrt(square);
}

// The frame after the last is the first, and the step from the last to it is no jump: not longer
// than the longest step inside the loop.
TEST(Promises, LoopsCloseWithoutAJump) {
    int loops = 0;
    for (const std::string& name : animation_names()) {
        const Scene scene = load(name);
        if (!scene.timeline.loops) continue;
        ++loops;
        const int frames = scene.timeline.frames;
        EXPECT_LT(distance(seen(scene, 1), seen(scene, frames + 1)), 1e-6) << name;
        double longest = 0;
        for (int frame = 1; frame < frames; ++frame) {
            longest = std::max(longest, distance(seen(scene, frame), seen(scene, frame + 1)));
        }
        EXPECT_LE(distance(seen(scene, frames), seen(scene, 1)), 1.01 * longest) << name;
    }
    EXPECT_GE(loops, 20);
}

} // namespace
} // namespace isomotion::scene
