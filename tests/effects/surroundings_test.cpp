// Ground, fog, occlusion and mirrors against closed forms.
#include <cmath>

#include <fmt/format.h>

#include "render/drawing.h"

namespace isomotion::render::surroundings_test {
namespace {

class Surroundings : public Drawing {
protected:
    Picture drawn(const std::string& text) const { return draw(*context, scene_of(text)); }
    static double red(const Picture& picture, std::size_t pixel) {
        return double(picture.frame.find("R")->samples[pixel]);
    }
    static double depth(const Picture& picture, std::size_t pixel) {
        return double(picture.frame.find("Z")->samples[pixel]);
    }
};
ISOMOTION_ON_EVERY_BACKEND(Surroundings);

std::string ball(const std::string& more) {
    return "[surface]\nformula = \"x^2 + y^2 + z^2 - 1\"\nbounds = { sphere = 1.5 }\n"
           "[camera]\nposition = [5, 0, 0]\ntarget = [0, 0, 0]\n"
           "[output]\nsize = [65, 65]\nbackground = [0.25, 0.5, 0.75]\n" +
           more;
}

TEST_P(Surroundings, FogFadesByTheWayFromTheEye) {
    const Picture clear = drawn(ball(""));
    const Picture foggy = drawn(ball("[fog]\ndensity = 0.3\nstart = 2\ncolor = [1, 1, 1]\n"));
    for (std::size_t row = 0; row < 65; ++row) {
        const std::size_t pixel = row * 65 + 32;
        if (!std::isfinite(depth(clear, pixel))) continue;
        // The middle column: the way is the depth over the cosine to the axis.
        const double v = 1 - (2.0 * double(row) + 1) / 65;
        const double way = depth(clear, pixel) * std::hypot(1, v * std::tan(M_PI / 9));
        const double left = std::exp(-0.3 * (way - 2));
        EXPECT_NEAR(red(foggy, pixel), 1 + (red(clear, pixel) - 1) * left, 2e-5);
    }
    // Nothing is hit outside: there is no fog on the sky.
    EXPECT_FLOAT_EQ(float(red(foggy, 0)), 0.25f);
}

TEST_P(Surroundings, FogIsTheSameInAnotherUnitOfLength) {
    const Picture one = drawn(ball("[fog]\ndensity = 0.3\n"));
    std::string large = ball("[fog]\ndensity = 0.0003\n");
    large.replace(large.find("[5, 0, 0]"), 9, "[5000, 0, 0]");
    large.replace(large.find("bounds ="), 8, "transform = { scale = 1000 }\nbounds =");
    const Picture other = drawn(large);
    for (std::size_t pixel = 0; pixel < 65 * 65; ++pixel) {
        ASSERT_NEAR(red(one, pixel), red(other, pixel), 1e-4) << "pixel " << pixel;
    }
}

TEST_P(Surroundings, GroundIsWhereItsPlaneIs) {
    const Picture picture =
        drawn("[surface]\nformula = \"x^2 + y^2 + z^2 - 0.01\"\nbounds = { sphere = 0.2 }\n"
              "[camera]\nposition = [0, -4, 2]\ntarget = [0, 0, 2]\nfov = 60\n"
              "[ground]\nheight = 0.5\ncolor = [0, 0, 0]\n"
              "[output]\nsize = [64, 64]\nbackground = [1, 1, 1]\n");
    for (std::size_t row = 0; row < 64; ++row) {
        // Level eye: below the horizon all is ground, above it sky.
        EXPECT_EQ(red(picture, row * 64), row < 32 ? 1 : 0) << "row " << row;
    }
}

TEST_P(Surroundings, TheGroundIsNoMetalWhereTheSurfaceIs) {
    const std::string look = "[ground]\nheight = -1\ncolor = [0.4, 0.6, 0.8]\n[material]\nmodel = "
                             "\"ggx\"\nmetallic = ";
    const Picture plastic = drawn(ball(look + "0\n")), metal = drawn(ball(look + "1\n"));
    int seen = 0;
    for (std::size_t pixel = 0; pixel < 65 * 65; ++pixel) {
        if (std::isfinite(depth(plastic, pixel))) continue; // on the ball
        ASSERT_EQ(red(plastic, pixel), red(metal, pixel)) << pixel;
        seen += red(plastic, pixel) != 0.25; // not the sky
    }
    EXPECT_GT(seen, 100);
}

TEST_P(Surroundings, NothingIsNearAPlane) {
    const std::string plane = "[surface]\nformula = \"z\"\nbounds = { sphere = 1 }\n"
                              "[camera]\nposition = [0, -3, 2]\n[output]\nsize = [64, 64]\n";
    const Picture plain = drawn(plane);
    const Picture occluded = drawn(plane + "[occlusion]\nradius = 0.5\n");
    for (std::size_t pixel = 0; pixel < 64 * 64; ++pixel) {
        ASSERT_NEAR(red(plain, pixel), red(occluded, pixel), 1e-5);
    }
}

TEST_P(Surroundings, CornersAreDarkerThanFaces) {
    // Two walls: F = min(x, y), seen from where both are positive.
    const std::string walls = "[surface]\nformula = \"min(x, y)\"\nbounds = { sphere = 1 }\n"
                              "[camera]\nposition = [3, 3, 0.001]\ntarget = [0, 0, 0]\n"
                              "[[lights]]\ndirection = [1, 1, 0]\ncolor = [0, 0, 0]\n"
                              "[output]\nsize = [65, 65]\n";
    const Picture picture = drawn(walls + "[occlusion]\nradius = 0.5\n");
    const std::size_t middle = 32 * 65 + 32;
    EXPECT_LT(red(picture, middle), 0.6 * red(picture, middle + 15));
    EXPECT_GE(red(picture, middle), 0);
    const Picture half = drawn(walls + "[occlusion]\nradius = 0.5\nstrength = 0.5\n");
    const Picture none = drawn(walls + "[occlusion]\nradius = 0.5\nstrength = 0\n");
    EXPECT_NEAR(red(half, middle), 0.5 * (red(picture, middle) + red(none, middle)), 1e-6);
}

// A mirror ball in the middle of a room of one colour sees nothing but that colour.
TEST_P(Surroundings, MirrorsMixByFresnel) {
    const Picture plain = drawn(ball(""));
    const Picture mirror = drawn(ball("[material]\nreflection = \"sky\"\n"));
    const std::size_t middle = 32 * 65 + 32;
    EXPECT_NEAR(red(mirror, middle), 0.96 * red(plain, middle) + 0.04 * 0.25, 1e-5);
}

TEST_P(Surroundings, AConvexSurfaceDoesNotMirrorItself) {
    const Picture sky = drawn(ball("[material]\nreflection = \"sky\"\n"));
    const Picture self = drawn(ball("[material]\nreflection = \"self\"\n"));
    for (std::size_t pixel = 0; pixel < 65 * 65; ++pixel) {
        ASSERT_NEAR(red(sky, pixel), red(self, pixel), 1e-6) << "pixel " << pixel;
    }
    EXPECT_GT(self.evaluations(), 0);
}

// The floor z = 0 beside a wall x = -1 that is lit from the front: the floor, which the light
// grazes, shows the wall by Fresnel's weight.
TEST_P(Surroundings, AFloorMirrorsAWall) {
    const std::string room = "[surface]\nformula = \"min(z, x + 1)\"\nbounds = { sphere = 6 }\n"
                             "[camera]\nposition = [2.5, 0, 0.5]\ntarget = [0, 0, 0]\n"
                             "up = [0, 0, 1]\nfov = 20\n[[lights]]\ndirection = [1, 0, 0]\n"
                             "[output]\nsize = [65, 65]\nbackground = [0, 0, 0]\n"
                             "[material]\ncolor = [1, 1, 1]\n";
    const Picture mirror = drawn(room + "reflection = \"self\"\n");
    const double cosine = 0.5 / std::hypot(2.5, 0.5); // of the middle ray to the floor's normal
    const auto coat = [](double c) { return 0.04 + 0.96 * std::pow(1 - c, 5); };
    const double weight = coat(cosine);
    // The wall is a mirror too, of the black around.
    const double wall = 1.12 * (1 - coat(2.5 / std::hypot(2.5, 0.5)));
    EXPECT_NEAR(red(mirror, 32 * 65 + 32), 0.12 * (1 - weight) + wall * weight, 1e-4);
}

// The same with a ball before the light: what the floor shows of the wall is its shadow.
TEST_P(Surroundings, AFloorMirrorsTheShadowOnAWall) {
    const std::string room =
        "[surface]\nformula = \"min(z, x + 1, sqrt((x - 4)^2 + y^2 + (z - 0.2)^2) - 0.12)\"\n"
        "bounds = { sphere = 6 }\n[camera]\nposition = [2.5, 0, 0.5]\ntarget = [0, 0, 0]\n"
        "up = [0, 0, 1]\nfov = 20\n[[lights]]\ndirection = [1, 0, 0]\nshadow = true\n"
        "[output]\nsize = [65, 65]\nbackground = [0, 0, 0]\n"
        "[material]\ncolor = [1, 1, 1]\nreflection = \"self\"\n";
    const Picture mirror = drawn(room);
    const auto coat = [](double c) { return 0.04 + 0.96 * std::pow(1 - c, 5); };
    const double way = std::hypot(2.5, 0.5), weight = coat(0.5 / way);
    const double dark = 0.12 * (1 - coat(2.5 / way));
    EXPECT_NEAR(red(mirror, 32 * 65 + 32), 0.12 * (1 - weight) + dark * weight, 1e-4);
    // Where it mirrors what is beside the shadow, it is as light as before.
    const double lit = (1.0 + 0.12) * (1 - coat(2.5 / way));
    EXPECT_GT(red(mirror, 32 * 65 + 12), 0.8 * (0.12 * (1 - weight) + lit * weight));
}

} // namespace
} // namespace isomotion::render::surroundings_test
