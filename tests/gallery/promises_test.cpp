// What animations promise, from their values alone: no GL.
#include <cmath>
#include <set>

#include "gallery/animations.h"
#include "scene/cut.h"
#include "scene/reading/load.h"
#include "scene/scene_at.h"

namespace isomotion::scene {
namespace {

TEST(Promises, EverySurfaceMovesInSomeAnimation) {
    std::set<std::string> moved;
    for (const std::string& name : animation_names()) moved.insert(load(name).surfaces[0].name);
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

// What the formula sees changes, or what is cut off, not only the camera.
TEST(Promises, TheSurfaceItselfMoves) {
    for (const std::string& name : animation_names()) {
        const Scene scene = load(name);
        const SceneAt first = at_frame(scene, 1);
        bool moves = false;
        for (int frame = 2; frame <= scene.timeline.frames && !moves; ++frame) {
            const SceneAt now = at_frame(scene, frame);
            moves = now.surfaces[0].bindings.parameters != first.surfaces[0].bindings.parameters ||
                    scene::packed(now.sections) != scene::packed(first.sections);
            for (std::size_t a = 0; a < now.surfaces[0].bindings.arrays.size(); ++a) {
                moves = moves || now.surfaces[0].bindings.arrays[a].fields !=
                                     first.surfaces[0].bindings.arrays[a].fields;
            }
        }
        EXPECT_TRUE(moves) << name;
    }
}

TEST(Promises, ParametersStayInTheSurfacesRanges) {
    for (const std::string& name : animation_names()) {
        const Scene scene = load(name);
        for (int frame = 1; frame <= scene.timeline.frames; ++frame) {
            const auto values = scene.surfaces[0].animation.at(scene.timeline.time(frame)).tracks;
            for (std::size_t k = 0; k < scene.surfaces[0].ranges.size(); ++k) {
                ASSERT_TRUE(scene.surfaces[0].ranges[k].contains(values[k]))
                    << name << " frame " << frame << ": "
                    << scene.surfaces[0].animation.tracks()[k].name << " = " << values[k];
            }
        }
    }
}

// Points spread over the bounds' surface.
std::vector<glm::dvec3> boundary(const BoundsAt& bounds, int count) {
    std::vector<glm::dvec3> points;
    for (int k = 0; k < count; ++k) {
        // Golden-angle spiral on the sphere; on a box the same directions, out to its faces.
        const double z = 1 - (2 * k + 1.0) / count, q = std::sqrt(1 - z * z);
        const double angle = k * M_PI * (3 - std::sqrt(5.0));
        const glm::dvec3 direction(q * std::cos(angle), q * std::sin(angle), z);
        if (bounds.shape == Bounds::Shape::sphere) {
            points.push_back(bounds.centre + bounds.radius * direction);
            continue;
        }
        const glm::dvec3 half = 0.5 * (bounds.max - bounds.min);
        const glm::dvec3 size = glm::abs(direction);
        points.push_back(bounds.centre + half * direction / std::max({size.x, size.y, size.z}));
    }
    return points;
}

// A surface that shows one side only is whole: its bounds do not cut it open at any frame. Where
// sections do, its inside is seen anyway.
TEST(Promises, SurfacesOfOneColourStayInTheirBounds) {
    int whole = 0;
    for (const std::string& name : animation_names()) {
        const Scene scene = load(name);
        if (scene.surfaces[0].material.inside || !scene.sections.empty()) continue;
        ++whole;
        formula::FieldEvaluator<double> field(*scene.surfaces[0].field);
        for (int frame = 1; frame <= scene.timeline.frames; frame += 3) {
            const SceneAt now = at_frame(scene, frame);
            const auto bindings = formula::convert<double>(now.surfaces[0].bindings);
            int negative = 0, positive = 0;
            for (const glm::dvec3& p : boundary(now.surfaces[0].bounds, 500)) {
                const double f = field.value(bindings, {p.x, p.y, p.z});
                negative += f < 0;
                positive += f > 0;
            }
            ASSERT_EQ(std::min(negative, positive), 0) << name << " frame " << frame;
        }
    }
    EXPECT_GE(whole, 20);
}

TEST(Promises, MostAnimationsLoop) {
    int loops = 0;
    for (const std::string& name : animation_names()) loops += load(name).timeline.loops;
    EXPECT_GE(loops, 50);
}

} // namespace
} // namespace isomotion::scene
