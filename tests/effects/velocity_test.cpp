// The channel velocity against surfaces whose motion is known.
#include <cmath>

#include <fmt/format.h>

#include "render/drawing.h"
#include "roots/certify.h"

namespace isomotion::render::velocity_test {
namespace {

class Velocity : public Drawing {
protected:
    Picture drawn(const scene::Scene& scene, int frame) const {
        Renderer renderer(*context, scene,
                          {scene.output.width,
                           scene.output.height,
                           {shader::Channel::normal, shader::Channel::position,
                            shader::Channel::verdict, shader::Channel::velocity},
                           {}});
        const Motion motion = motion_about(scene, frame);
        return renderer.draw(scene::at_frame(scene, frame), {}, &motion);
    }
    static double value(const Picture& picture, const char* layer, std::size_t pixel) {
        return double(picture.frame.find(layer)->samples[pixel]);
    }
    static bool is_hit(const Picture& picture, std::size_t pixel) {
        return value(picture, "verdict", pixel) == double(Verdict::hit);
    }
    static constexpr std::size_t middle = 32 * 65 + 32;
};
ISOMOTION_ON_EVERY_BACKEND(Velocity);

std::string ball(const std::string& formula, const std::string& more = {}) {
    return fmt::format("[time]\nfps = 25\nframes = 50\n[surface]\nformula = \"{}\"\n"
                       "bounds = {{ sphere = 2 }}\n[camera]\nposition = [8, 0, 0]\n"
                       "target = [0, 0, 0]\nup = [0, 0, 1]\nprojection = \"orthographic\"\n"
                       "height = 4\n[output]\nsize = [65, 65]\n{}",
                       formula, more);
}

TEST_P(Velocity, OfAGrowingSphereIsItsRadius) {
    const scene::Scene scene =
        scene_of(ball("x^2 + y^2 + z^2 - r^2", "[parameters]\nr = \"1 + 0.3*t\"\n"));
    const Picture picture = drawn(scene, 20);
    int hits = 0;
    for (std::size_t pixel = 0; pixel < 65 * 65; ++pixel) {
        if (!is_hit(picture, pixel)) {
            EXPECT_EQ(value(picture, "velocity.N", pixel), 0);
            continue;
        }
        ++hits;
        ASSERT_NEAR(value(picture, "velocity.N", pixel), 0.3, 1e-3);
        // Outwards, as far as the normal lies in the picture: 65 pixels are 4 units.
        ASSERT_NEAR(value(picture, "velocity.X", pixel),
                    0.3 * value(picture, "N.Y", pixel) * 65 / 4, 0.02);
        ASSERT_NEAR(value(picture, "velocity.Y", pixel),
                    -0.3 * value(picture, "N.Z", pixel) * 65 / 4, 0.02);
    }
    EXPECT_GT(hits, 500);
}

TEST_P(Velocity, OfATravellingSphereIsAlongItsNormal) {
    const scene::Scene scene =
        scene_of(ball("x^2 + (y - c)^2 + z^2 - 1", "[parameters]\nc = \"0.5*t\"\n"));
    const Picture picture = drawn(scene, 10);
    for (std::size_t pixel = 0; pixel < 65 * 65; ++pixel) {
        if (!is_hit(picture, pixel)) continue;
        ASSERT_NEAR(value(picture, "velocity.N", pixel), 0.5 * value(picture, "N.Y", pixel), 1e-3);
    }
}

// The same motion by the placement, and a surface that stands still under a camera that moves.
TEST_P(Velocity, OfAPlacementAndOfTheCamera) {
    std::string text = ball("x^2 + y^2 + z^2 - 1");
    text.replace(text.find("bounds ="), 8,
                 "transform = { translate = [0, \"0.5*t\", 0], scale = 1.5 }\nbounds =");
    const Picture placed = drawn(scene_of(text), 10);
    for (std::size_t pixel = 0; pixel < 65 * 65; ++pixel) {
        if (!is_hit(placed, pixel)) continue;
        ASSERT_NEAR(value(placed, "velocity.N", pixel), 0.5 * value(placed, "N.Y", pixel), 1e-3);
    }
    std::string camera = ball("x^2 + y^2 + z^2 - 1");
    camera.replace(camera.find("[8, 0, 0]"), 9, "[8, \"0.5*t\", 0]");
    camera.replace(camera.find("target = [0, 0, 0]"), 18, "target = [0, \"0.5*t\", 0]");
    const Picture seen = drawn(scene_of(camera), 10);
    EXPECT_NEAR(value(seen, "velocity.N", middle), 0, 1e-4);
    EXPECT_NEAR(value(seen, "velocity.X", middle), -0.5 * 65 / 4, 1e-3);
    EXPECT_NEAR(value(seen, "velocity.Y", middle), 0, 1e-3);
}

// Finite differences of the certified hit: along the ray it moves by speed / cos(ray, normal).
TEST_P(Velocity, IsHowTheCertifiedHitMoves) {
    const scene::Scene scene = scene_of(
        ball("x^4 + y^4 + z^4 - c*(x^2 + y^2 + z^2) + 0.4", "[parameters]\nc = \"1.5 + 0.2*t\"\n"));
    const int frame = 25;
    const Picture picture = drawn(scene, frame);
    const Motion motion = motion_about(scene, frame);
    const auto root = [&](const scene::SceneAt& at) {
        return roots::certify(scene, at, 65, 65).roots;
    };
    const auto before = root(motion.before), after = root(motion.after);
    int compared = 0;
    for (std::size_t pixel = 0; pixel < 65 * 65; ++pixel) {
        const double cosine = value(picture, "N.X", pixel); // the rays run along -x
        if (!is_hit(picture, pixel) || std::abs(cosine) < 0.3) continue;
        if (before[pixel].answer != roots::Answer::hit ||
            after[pixel].answer != roots::Answer::hit) {
            continue;
        }
        const auto t = [](const roots::FirstRoot& r) {
            return 0.5 * (double(r.low) + double(r.high));
        };
        const double along = (t(after[pixel]) - t(before[pixel])) / motion.seconds;
        ++compared;
        ASSERT_NEAR(value(picture, "velocity.N", pixel), -along * cosine, 1e-2);
    }
    EXPECT_GT(compared, 500);
}

TEST_P(Velocity, ChangesNoOtherChannel) {
    const scene::Scene scene =
        scene_of(ball("x^2 + y^2 + z^2 - r^2", "[parameters]\nr = \"1 + 0.3*t\"\n"));
    const Picture with = drawn(scene, 20);
    const Picture without = draw(*context, scene, 20);
    for (const char* layer : {"R", "G", "B", "A", "N.X", "P.Y", "verdict"}) {
        EXPECT_EQ(with.frame.find(layer)->samples, without.frame.find(layer)->samples) << layer;
    }
}

// Both ends of an animation, and one that stands still.
TEST_P(Velocity, AtTheEndsOfAnAnimation) {
    const scene::Scene scene =
        scene_of(ball("x^2 + y^2 + z^2 - r^2", "[parameters]\nr = \"1 + 0.3*t\"\n"));
    for (const int frame : {1, 50}) {
        EXPECT_NEAR(value(drawn(scene, frame), "velocity.N", middle), 0.3, 2e-3) << frame;
    }
    EXPECT_EQ(value(drawn(scene_of(ball("x^2 + y^2 + z^2 - 1")), 1), "velocity.N", middle), 0);
}

// One that grows beside one that moves, before one that turns in its place, in either order.
TEST_P(Velocity, OfSeveralIsThatOfTheSurfaceThatIsSeen) {
    const std::string grows =
        "[[surfaces]]\nformula = \"x^2 + y^2 + z^2 - r^2\"\nbounds = { sphere = 2 "
        "}\nparameters = { r = \"0.5 + 0.3*t\" }\ntransform = { translate = [0, -1, "
        "0] }\n";
    const std::string moves =
        "[[surfaces]]\nformula = \"x^2 + y^2 + z^2 - 4\"\nbounds = { sphere = 3 }\n"
        "transform = { translate = [0, \"0.6 + 0.5*t\", 0], scale = 0.3 }\n";
    const std::string turns =
        "[[surfaces]]\nformula = \"x^2 + y^2 + z^2 - 1\"\nbounds = { sphere = 2 }\n"
        "transform = { translate = [-3, 0, 0], rotate = [\"90*t\", 0, 0], scale = "
        "1.9 }\n";
    const std::string view = "[time]\nfps = 25\nframes = 50\n[camera]\nposition = [8, 0, 0]\n"
                             "target = [0, 0, 0]\nup = [0, 0, 1]\nprojection = \"orthographic\"\n"
                             "height = 4\n[output]\nsize = [65, 65]\n";
    for (const bool first : {true, false}) {
        const scene::Scene scene = scene_of((first ? grows + moves : moves + grows) + turns + view);
        Renderer renderer(
            *context, scene,
            {65,
             65,
             {shader::Channel::normal, shader::Channel::surface, shader::Channel::velocity},
             {}});
        const Motion motion = motion_about(scene, 20);
        const Picture picture = renderer.draw(scene::at_frame(scene, 20), {}, &motion);
        int seen[4]{};
        for (std::size_t pixel = 0; pixel < 65 * 65; ++pixel) {
            const int surface = int(value(picture, "surface", pixel));
            ++seen[surface];
            const double y = value(picture, "N.Y", pixel);
            const double expected = surface == (first ? 1 : 2)   ? 0.3
                                    : surface == (first ? 2 : 1) ? 0.5 * y
                                                                 : 0;
            ASSERT_NEAR(value(picture, "velocity.N", pixel), expected, 2e-3) << surface;
            if (surface == 0 || surface == 3) continue;
            ASSERT_NEAR(value(picture, "velocity.X", pixel), expected * y * 65 / 4, 0.03);
        }
        for (const int count : seen) EXPECT_GT(count, 100);
    }
}

} // namespace
} // namespace isomotion::render::velocity_test
