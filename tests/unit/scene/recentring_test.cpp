// Scenes far from the origin, as maps and surveys have them: coordinates are counted from near the
// bounds, and all that a scene says goes on meaning the same.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "probe/sight.h"
#include "probe/thresholds.h"
#include "scene/scene_at.h"
#include "testing.h"

namespace isomotion::scene {
namespace {

class Recentring : public Scenes {};

glm::dvec3 origin_of(const Scene& scene) {
    const auto& origin = scene.surfaces[0].field->origin.point;
    return {origin[0], origin[1], origin[2]};
}

// F, times its scale, at a point of the world.
double field_at(const Scene& scene, const SceneAt& now, const glm::dvec3& world) {
    const SurfaceAt& surface = now.surfaces[0];
    const glm::dvec3 p = surface.placement.to_local(world);
    return formula::FieldEvaluator<double>(*scene.surfaces[0].field)
        .value(formula::convert<double>(surface.bindings), {p.x, p.y, p.z});
}

const char* const far_ball = "(x - 500000)^2 + (y - 4649776)^2 + (z - 120)^2 - 900";

TEST_F(Recentring, MovesWhatLiesFarAway) {
    const Scene scene = loaded(fmt::format("[surface]\nformula = \"{}\"\nbounds = {{ box = "
                                           "[[499960, 4649736, 80], [500040, 4649816, 160]] }}",
                                           far_ball));
    const SceneAt now = at_frame(scene, 1);
    EXPECT_EQ(origin_of(scene), glm::dvec3(500000, 4649776, 120));
    EXPECT_EQ(now.surfaces[0].bounds.min, glm::dvec3(-40));
    EXPECT_EQ(now.surfaces[0].bounds.max, glm::dvec3(40));
    EXPECT_NEAR(field_at(scene, now, {500030, 4649776, 120}), 0, 1e-6);
    EXPECT_LT(glm::distance(now.camera.target, {500000, 4649776, 120}), 1e-6);
    EXPECT_FALSE(probe::sight(scene, now).far_middle);
    EXPECT_LT(probe::float32_displacement(*scene.surfaces[0].field, now.surfaces[0]), 1e-6);
}

TEST_F(Recentring, MovesWithBoundsPlacementAndColours) {
    const Scene scene = loaded(R"(
[time]
frames = 31
[surface]
formula = "(x - 500000)^2 + (y - 4649776)^2 + (z - 120)^2 - 900*p"
bounds = { sphere = 40, centre = ["500000 + 3*t", 4649776, { keys = [[0, 120], [1, 125]] }] }
transform = { rotate = [0, 0, 90], scale = 2, translate = ["10*t", 20, 30] }
[parameters]
p = "1 + t"
[material]
color = ["x/1000000", "y - 4649776", 0]
)");
    const SceneAt now = at_frame(scene, 31);
    const SurfaceAt& surface = now.surfaces[0];
    EXPECT_EQ(origin_of(scene), glm::dvec3(500000, 4649776, 120));
    EXPECT_EQ(surface.bounds.centre, glm::dvec3(3, 0, 5));
    // World = translate + 2 (-y, x, z).
    const glm::dvec3 middle(10 - 2 * 4649776.0, 20 + 2 * 500000.0, 30 + 240);
    EXPECT_LT(glm::distance(surface.placement.to_world(glm::dvec3(0)), middle), 1e-6);
    EXPECT_NEAR(field_at(scene, now, middle) / scene.surfaces[0].field->scale, -1800, 1e-6);
    const auto& color = scene.surfaces[0].material.color_by_place;
    ASSERT_TRUE(color);
    formula::Evaluator<double> paint(color->value);
    std::array<double, 13> inputs{};
    inputs[1] = 0.5;
    std::array<double, 3> result{};
    paint.point(formula::convert<double>(surface.bindings), inputs, result);
    EXPECT_NEAR(result[0], 0.5, 1e-9);
    EXPECT_NEAR(result[1], 0.5, 1e-9);
}

// Terms that a formula repeats become elements again, of numbers counted from there.
TEST_F(Recentring, MovesTermsThatAreWrittenOut) {
    std::string sum;
    for (int k = 0; k < 20; ++k) {
        sum += fmt::format("{}exp(-((x - {})^2 + (y - {})^2 + (z - 120)^2)/50)", k ? " + " : "",
                           500000 + 7 * (k % 5), 4649776 + 9 * (k / 5));
    }
    const Scene scene = loaded(fmt::format(
        "[surface]\nformula = \"{} - 0.5\"\nbounds = {{ sphere = 60, centre = [500000, 4649776, "
        "120] }}",
        sum));
    EXPECT_EQ(origin_of(scene), glm::dvec3(500000, 4649776, 120));
    EXPECT_EQ(scene.surfaces[0].animation.arrays().size(), 1u);
    const SceneAt now = at_frame(scene, 1);
    EXPECT_LT(probe::float32_displacement(*scene.surfaces[0].field, now.surfaces[0]), 1e-6);
}

// What moves goes on moving.
TEST_F(Recentring, MovesParametersAndElements) {
    const Scene scene = loaded(R"toml(
[time]
frames = 31
[surface]
formula = "min(sum(b, exp(-((x - cx)^2 + (y - cy)^2 + (z - cz)^2)/50)) - 0.5, (x - px)^2 + (y - 4649776)^2 + (z - 120)^2 - 9*r)"
bounds = { sphere = 60, centre = [500000, 4649776, 120] }
[parameters]
px = "500000 + 10*t"
r = 4
[arrays.b]
count = 12
cx = "500000 + 20*sin(i) + t"
cy = "4649776 + 20*cos(i)"
cz = [100, 105, 110, 115, 120, 125, 130, 135, 140, 145, 150, 155]
)toml");
    ASSERT_EQ(origin_of(scene), glm::dvec3(500000, 4649776, 120));
    const SceneAt now = at_frame(scene, 31);
    EXPECT_LT(probe::float32_displacement(*scene.surfaces[0].field, now.surfaces[0]), 1e-5);
    const auto f = [&](const glm::dvec3& p) {
        double sum = -0.5;
        for (int i = 0; i < 12; ++i) {
            const glm::dvec3 centre(500001 + 20 * std::sin(i), 4649776 + 20 * std::cos(i),
                                    100 + 5 * i);
            sum += std::exp(-glm::dot(p - centre, p - centre) / 50);
        }
        const glm::dvec3 off = p - glm::dvec3(500010, 4649776, 120);
        return std::min(sum, glm::dot(off, off) - 36);
    };
    for (int k = 0; k < 20; ++k) {
        const glm::dvec3 p(499990 + 2.0 * k, 4649770 + k, 110 + k);
        EXPECT_NEAR(field_at(scene, now, p) / scene.surfaces[0].field->scale, f(p), 1e-4);
    }
}

// Where it does not help, a warning says what to write.
TEST_F(Recentring, WarnsWhereItDoesNotHelp) {
    const std::string bounds = "bounds = { sphere = 40, centre = [500000, 4649776, 120] }\n";
    const auto warns = [&](const std::string& text, const std::string& more = "") {
        const Scene scene = loaded(text + more);
        return probe::sight(scene, at_frame(scene, 1)).far_middle.has_value();
    };
    EXPECT_TRUE(warns("[surface]\nformula = \"x^2 - 1000000*x + y^2 - 9299552*y + z^2 - 240*z + "
                      "21870416851076\"\n" +
                      bounds));
    EXPECT_TRUE(warns(fmt::format("[surface]\nformula = \"{}\"\n{}transform = {{ rotate = [0, 0, "
                                  "\"t\"] }}\n",
                                  far_ball, bounds)));
    // Nothing is known of what has no slope.
    EXPECT_FALSE(warns("[surface]\nformula = \"-1\"\n" + bounds,
                       "[[sections]]\nnormal = [1, 0, 0]\npoint = [500000, 0, 0]\n"));
    EXPECT_FALSE(warns("[surface]\nformula = \"sign(x - 500000) + y - 4649776\"\n" + bounds));
}

TEST_F(Recentring, LeavesWhatIsNearAtSomeFrame) {
    const auto origin = [&](const char* formula, const char* bounds) {
        const Scene scene = loaded(fmt::format(
            "[time]\nframes = 31\n[surface]\nformula = \"{}\"\nbounds = {}\n", formula, bounds));
        return origin_of(scene);
    };
    EXPECT_EQ(origin("sin(x/3)*cos(y/3) + sin(z/3)",
                     "{ sphere = 10, centre = [{ keys = [[0, 500000], [1, 0]] }, 0, 0] }"),
              glm::dvec3(0));
    EXPECT_EQ(origin("sin(x/3)*cos(y/3) + sin(z/3)",
                     "{ sphere = 10, centre = [{ keys = [[0, 500000], [0.3, 0], [0.7, 500000]] }, "
                     "0, 0] }"),
              glm::dvec3(0));
    EXPECT_EQ(origin("(x - 100)^2 + y^2 + z^2 - 1", "{ sphere = 2, centre = [100, 0, 0] }"),
              glm::dvec3(0));
    // Nor what has statements of its own.
    EXPECT_EQ(origin(far_ball, "{ sphere = 40, centre = ['u = 3*t; 500000 + u', 4649776, 120] }"),
              glm::dvec3(0));
}

TEST_F(Recentring, TellsFieldsApart) {
    const auto text = [&](double x) {
        return fmt::format("[surface]\nformula = \"{}\"\nbounds = {{ sphere = 40, centre = [{}, "
                           "4649776, 120] }}\n",
                           far_ball, x);
    };
    const Scene a = loaded(text(500000)), b = loaded(text(500040));
    EXPECT_NE(formula::identity(*a.surfaces[0].field), formula::identity(*b.surfaces[0].field));
    EXPECT_EQ(formula::identity(formula::make_field("x - 1", {})), "x - 1");
}

} // namespace
} // namespace isomotion::scene
