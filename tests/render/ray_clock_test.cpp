// The time of beams and rays that a picture tells if it is asked for.
#include "render/drawing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "gpu/compute.h"

namespace isomotion::render {
namespace {

class RayClockOf : public Drawing {
protected:
    // Draws a scene with and without the clock.
    void expect_times_rays(const scene::Scene& scene, StageChoice stage, MarchPlan plan) {
        RenderOptions options{96, 64, {}, plan};
        options.stage = stage;
        const Picture untimed = draw(scene, options);
        options.times_rays = true;
        const Picture timed = draw(scene, options);
        EXPECT_EQ(untimed.marching.count(), 0);
        EXPECT_GT(timed.marching.count(), 0);
        EXPECT_LT(timed.marching, timed.drawing);
        EXPECT_EQ(timed.passes, untimed.passes);
        ASSERT_EQ(timed.frame.channels.size(), untimed.frame.channels.size());
        for (std::size_t k = 0; k < timed.frame.channels.size(); ++k)
            EXPECT_EQ(timed.frame.channels[k].samples, untimed.frame.channels[k].samples);
    }

private:
    Picture draw(const scene::Scene& scene, const RenderOptions& options) {
        Renderer renderer(*context, scene, options);
        return renderer.draw(scene::at_frame(scene, 1));
    }
};
ISOMOTION_ON_EVERY_BACKEND(RayClockOf);

constexpr const char* ball = "formula = \"x^2 + y^2 + z^2 - 1\"\nbounds = { sphere = 1.5 }\n";

TEST_P(RayClockOf, OneDrawAndManyPasses) {
    const scene::Scene scene = scene_of(std::string("[surface]\n") + ball);
    for (const MarchPlan plan : {MarchPlan{96, 64, 1000}, MarchPlan{32, 32, 3}}) {
        expect_times_rays(scene, StageChoice::fragment, plan);
        if (gpu::has_compute(context->info())) expect_times_rays(scene, StageChoice::compute, plan);
    }
}

TEST_P(RayClockOf, SeveralSurfacesAndShadows) {
    const std::string surfaces = std::string("[[surfaces]]\nname = \"a\"\n") + ball +
                                 "[[surfaces]]\nname = \"b\"\n" + ball +
                                 "transform = { translate = [1, 0, 0] }\n";
    const std::string shadows = "[[lights]]\ndirection = [1, 2, 3]\nshadow = true\n";
    for (const std::string& text : {surfaces, surfaces + shadows})
        expect_times_rays(scene_of(text), StageChoice::fragment, {64, 64, 200});
}

} // namespace
} // namespace isomotion::render
