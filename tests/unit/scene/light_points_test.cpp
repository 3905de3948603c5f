// Lights with a size, from their points: angles and distances in closed form.
#include <random>

#include "scene/light_points.h"
#include "testing.h"

namespace isomotion::scene {
namespace {

class LightPoints : public Scenes {
protected:
    LightAt light_from(const std::string& light, const glm::dvec2& disc) const {
        const Scene scene = loaded(ball_and("[surface.transform]\ntranslate = [1, 2, 3]\n"
                                            "rotate = [10, 20, 30]\nscale = 2\n[[lights]]\n" +
                                            light));
        return lit_from(at_time(scene, 0), disc).lights.at(0);
    }
};

glm::dvec2 random_point_of_disc(std::mt19937& random) {
    const auto part = [&] { return std::generate_canonical<double, 53>(random); };
    const double radius = std::sqrt(part()), angle = 2 * M_PI * part();
    return radius * glm::dvec2(std::cos(angle), std::sin(angle));
}

TEST_F(LightPoints, FarLightsTurnByTheirAngleAtTheRim) {
    const std::string light = "direction = [1, 2, -2]\nradius = 10";
    const glm::dvec3 middle = light_from(light, {0, 0}).direction;
    EXPECT_EQ(middle, glm::dvec3(1, 2, -2) / 3.0);
    std::mt19937 random(29);
    for (int k = 0; k < 50; ++k) {
        const glm::dvec2 disc = random_point_of_disc(random);
        const glm::dvec3 moved = light_from(light, disc).direction;
        EXPECT_NEAR(glm::length(moved), 1, 1e-14);
        const double tangent = glm::length(glm::cross(middle, moved)) / glm::dot(middle, moved);
        EXPECT_NEAR(tangent, std::tan(glm::radians(10.0)) * glm::length(disc), 1e-14);
    }
}

TEST_F(LightPoints, ALightWithAPositionIsADiscThatFacesTheSurface) {
    const std::string light = "position = [4, 2, 7]\nradius = 0.5";
    const glm::dvec3 place(4, 2, 7),
        middle(1, 2, 3); // to where the transform takes the ball's middle
    std::mt19937 random(28);
    for (int k = 0; k < 50; ++k) {
        const glm::dvec2 disc = random_point_of_disc(random);
        const glm::dvec3 moved = light_from(light, disc).direction - place;
        EXPECT_NEAR(glm::length(moved), 0.5 * glm::length(disc), 1e-14);
        EXPECT_NEAR(glm::dot(moved, place - middle), 0, 1e-13);
    }
}

TEST_F(LightPoints, ALightWithoutARadiusStaysAndSoDoesTheCamera) {
    EXPECT_EQ(light_from("direction = [1, 2, -2]", {0.6, -0.5}).direction,
              glm::dvec3(1, 2, -2) / 3.0);
    EXPECT_EQ(light_from("position = [4, 2, 7]", {0.6, -0.5}).direction, glm::dvec3(4, 2, 7));
}

TEST_F(LightPoints, ARadiusIsAnAngleThatALightCanHave) {
    const std::string light = "[[lights]]\ndirection = [1, 0, 0]\nradius = ";
    EXPECT_EQ(loaded(ball_and(light + "3")).output.samples, 16);
    EXPECT_EQ(loaded(ball_with(14, "samples = 2\n" + light + "3")).output.samples, 2);
    EXPECT_THAT(mistake(ball_and(light + "50")),
                testing::HasSubstr("must be from 0 to 45, not 50"));
}

} // namespace
} // namespace isomotion::scene
