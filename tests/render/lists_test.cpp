// Lists of the elements that matter in a beam follow a number of elements that changes: no list is
// left from the frame before (scenes/lists.toml has what lists leave out).
#include "render/drawing.h"

#include <gtest/gtest.h>

namespace isomotion::render::lists_test {
namespace {

class Lists : public Drawing {};
ISOMOTION_ON_EVERY_BACKEND(Lists);

TEST_P(Lists, FollowANumberOfElementsThatChanges) {
    scene::Scene scene = scene_of(R"toml([surface]
formula = "sum(blobs, exp(-30*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - 0.5"
bounds = { sphere = 2 }
[arrays.blobs]
count = 75
cx = "2.4*random(i, 0) - 1.2"
cy = "2.4*random(i, 1) - 1.2"
cz = "2.4*random(i, 2) - 1.2"
[camera]
azimuth = 30
elevation = 20
[isolation]
method = "hermite"
beam = true
)toml");
    Renderer with(*context, scene, {97, 61, every_channel, {}});
    scene::Scene plain = scene;
    plain.surfaces[0].isolation.beam = false;
    Renderer without(*context, plain, {97, 61, every_channel, {}});
    for (const int elements : {75, 3, 0, 40, 1, 75}) {
        SCOPED_TRACE(elements);
        scene::SceneAt now = scene::at_frame(scene, 1);
        auto& blobs = now.surfaces[0].bindings.arrays[0];
        blobs.count = elements;
        for (auto& field : blobs.fields) field.resize(std::size_t(elements));
        const Picture a = without.draw(now), b = with.draw(now);
        EXPECT_EQ(count(a, Verdict::hit) > 0, elements > 0);
        int lost = 0, behind = 0;
        for (std::size_t k = 0; k < a.frame.find("Z")->samples.size(); ++k) {
            if (Verdict(int(a.frame.find("verdict")->samples[k])) != Verdict::hit) continue;
            if (a.frame.find("verdict")->samples[k] != b.frame.find("verdict")->samples[k]) {
                ++lost;
                continue;
            }
            const auto vector = [&](const char* x, const char* y, const char* z) {
                return glm::dvec3(a.frame.find(x)->samples[k], a.frame.find(y)->samples[k],
                                  a.frame.find(z)->samples[k]);
            };
            const glm::dvec3 way =
                glm::normalize(vector("P.X", "P.Y", "P.Z") - now.camera.position);
            const double cosine = std::abs(glm::dot(vector("N.X", "N.Y", "N.Z"), way));
            behind += cosine * (b.frame.find("Z")->samples[k] - a.frame.find("Z")->samples[k]) >=
                      2e-5; // of a radius of 2
        }
        EXPECT_LE(lost, 1);
        EXPECT_EQ(behind, 0);
    }
}

} // namespace
} // namespace isomotion::render::lists_test
