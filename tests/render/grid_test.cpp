// Elements found by place, of which there are none, one, or too many (scenes/elements_by_place.toml
// has the rest).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "render/drawing.h"

namespace isomotion::render::grid_test {
namespace {

class Grid : public Drawing {};
ISOMOTION_ON_EVERY_BACKEND(Grid);

scene::Scene elements(const char* kernel, int count) {
    return scene_of(fmt::format(R"toml([surface]
formula = "0.3 - sum(p, max(0, 1 - {}*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))^3)"
bounds = {{ sphere = 2 }}
[arrays.p]
count = {}
cx = "2.4*random(i, 0) - 1.2"
cy = "2.4*random(i, 1) - 1.2"
cz = "2.4*random(i, 2) - 1.2"
[camera]
azimuth = 30
elevation = 20
[output]
size = [49, 31]
)toml",
                                kernel, count));
}

TEST_P(Grid, DrawsNoElementOneAndMoreThanAShaderCanSum) {
    scene::Scene many = elements("4000", 70'000);
    EXPECT_GT(count(draw(*context, many), Verdict::hit), 250);
    scene::SceneAt now = scene::at_frame(many, 1);
    Renderer renderer(*context, many, {49, 31, every_channel});
    for (auto& column : now.surfaces[0].bindings.arrays[0].fields)
        column.resize(std::min<std::size_t>(column.size(), 1));
    now.surfaces[0].bindings.arrays[0].count = 1;
    EXPECT_LE(count(renderer.draw(now), Verdict::hit), 4);
    now.surfaces[0].bindings.arrays[0].count = 0;
    for (auto& column : now.surfaces[0].bindings.arrays[0].fields) column.clear();
    EXPECT_EQ(count(renderer.draw(now), Verdict::hit), 0);
}

TEST_P(Grid, SaysWhereTooManyMeet) {
    const scene::Scene scene = elements("0.1", 60'000);
    Renderer renderer(*context, scene, {16, 16, {}});
    EXPECT_THROW(renderer.draw(scene::at_frame(scene, 1)), std::length_error);
}

} // namespace
} // namespace isomotion::render::grid_test
