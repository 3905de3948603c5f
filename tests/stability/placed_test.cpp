// Size and place of a scene change nothing: any_size.toml changes them by the formula.
#include "scenes/hard_case.h"

#include <fmt/format.h>

#include "scene/data_folder.h"
#include "scene/reading/load.h"

namespace isomotion::stability {
namespace {

int different(const render::Picture& a, const render::Picture& b) {
    const auto& x = a.frame.find("verdict")->samples;
    const auto& y = b.frame.find("verdict")->samples;
    int count = 0;
    for (std::size_t k = 0; k < x.size(); ++k) count += x[k] != y[k];
    return count;
}

// The scene scaled and moved, and its camera, ground and sections, which lie in the world, with it.
scene::SceneAt moved(scene::SceneAt now, double scale, const glm::dvec3& by) {
    const auto place = [&](const glm::dvec3& p) { return by + scale * p; };
    for (scene::SurfaceAt& surface : now.surfaces) {
        surface.placement.translate = place(surface.placement.translate);
        surface.placement.scale *= scale;
    }
    now.camera.position = place(now.camera.position);
    now.camera.target = place(now.camera.target);
    now.camera.height *= scale;
    now.ground.height = by.z + scale * now.ground.height;
    for (scene::SectionAt& section : now.sections) {
        section.reach *= scale;
        if (section.is_ball)
            section.where = place(section.where);
        else
            section.reach += dot(section.where, by);
    }
    return now;
}

class Placed : public testing::TestWithParam<std::string> {};

TEST_P(Placed, GivesTheSameVerdicts) {
    const scene::Scene scene =
        scene::load(ISOMOTION_SOURCE_DIR "/animations/" + GetParam() + ".toml",
                    {"look=none", "output.size=[64, 64]"});
    const auto context = gpu::Context::create();
    render::Renderer renderer(*context, scene, {64, 64, {shader::Channel::verdict}, {}});
    const scene::SceneAt now = scene::at_frame(scene, scene.output.poster);
    const render::Picture unit = renderer.draw(now);
    EXPECT_GT(render::count(unit, render::Verdict::hit), 200);
    for (const double scale : {1e-3, 1.0, 1e3, 1e6}) {
        for (const double offset : {0.0, 1e6}) {
            SCOPED_TRACE(fmt::format("scale {}, moved by {}", scale, offset));
            // At 10^6 a thousandth of a unit still has seven digits of double.
            const glm::dvec3 by = offset * glm::dvec3(1, -1, 0.5);
            EXPECT_LE(different(unit, renderer.draw(moved(now, scale, by))), 2);
        }
    }
}

std::vector<std::string> animations() {
    setenv("ISOMOTION_DATA", ISOMOTION_SOURCE_DIR, /*overwrite=*/1); // wherever tests are built
    return scene::animation_names();
}

INSTANTIATE_TEST_SUITE_P(Stability, Placed, testing::ValuesIn(animations()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace isomotion::stability
