// The channel velocity against certified hits a moment apart (scenes/velocity.toml has closed
// forms).
#include <cmath>

#include <fmt/format.h>

#include "render/drawing.h"
#include "roots/certify.h"

namespace isomotion::render::velocity_test {
namespace {

class Velocity : public Drawing {};
ISOMOTION_ON_EVERY_BACKEND(Velocity);

// Finite differences of the certified hit: along the ray it moves by speed / cos(ray, normal).
TEST_P(Velocity, IsHowTheCertifiedHitMoves) {
    const scene::Scene scene = scene_of(R"toml([time]
fps = 25
frames = 50
[surface]
formula = "x^4 + y^4 + z^4 - c*(x^2 + y^2 + z^2) + 0.4"
bounds = { sphere = 2 }
[parameters]
c = "1.5 + 0.2*t"
[camera]
position = [8, 0, 0]
up = [0, 0, 1]
projection = "orthographic"
height = 4
[output]
size = [65, 65]
)toml");
    using shader::Channel;
    Renderer renderer(*context, scene,
                      {65, 65, {Channel::normal, Channel::verdict, Channel::velocity}, {}});
    const int frame = 25;
    const Motion motion = motion_about(scene, frame);
    const Picture picture = renderer.draw(scene::at_frame(scene, frame), {}, &motion);
    const auto value = [&](const char* layer, std::size_t pixel) {
        return double(picture.frame.find(layer)->samples[pixel]);
    };
    const auto root = [&](const scene::SceneAt& at) {
        return roots::certify(scene, at, 65, 65).roots;
    };
    const auto before = root(motion.before), after = root(motion.after);
    int compared = 0;
    for (std::size_t pixel = 0; pixel < 65 * 65; ++pixel) {
        const double cosine = value("N.X", pixel); // the rays run along -x
        if (value("verdict", pixel) != double(Verdict::hit) || std::abs(cosine) < 0.3) continue;
        if (before[pixel].answer != roots::Answer::hit ||
            after[pixel].answer != roots::Answer::hit) {
            continue;
        }
        const auto t = [](const roots::FirstRoot& r) {
            return 0.5 * (double(r.low) + double(r.high));
        };
        const double along = (t(after[pixel]) - t(before[pixel])) / motion.seconds;
        ++compared;
        ASSERT_NEAR(value("velocity.N", pixel), -along * cosine, 1e-2);
    }
    EXPECT_GT(compared, 500);
}

} // namespace
} // namespace isomotion::render::velocity_test
