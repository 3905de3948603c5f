// Rays whose steps branch, as on graphics cards, end where others do.
#include "drawing.h"

#include <array>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "gpu/compute.h"

namespace isomotion::render {
namespace {

// Smooth surfaces, one that is touched along a cuspidal edge, kinks, jumps and poles, no value
// where rays begin, elements in lists and by place, caps, and rays from the surface and through it.
const std::array<std::string, 10> met_by_branches{
    sphere_scene,
    "[surface]\nuse = 'barth_sextic'\n",
    "[surface]\nuse = 'cushion'\n",
    "[surface]\nformula = '(x^2 - 0.3*y)^2 - (z - 0.2*x)^3'\nbounds = { sphere = 1.2 }\n",
    "[surface]\nformula = 'max(min(x^2 + y^2 - 0.1, abs(z) - 0.1), x - 0.5)'\n"
    "bounds = { box = [[-1, -0.8, -0.6], [1, 0.8, 0.6]] }\n",
    "[surface]\nformula = 'floor(3*x) + 4*y + 1/(z + 0.31)'\nbounds = { sphere = 1 }\n",
    "[surface]\nformula = 'log(1 - x^2 - y^2) + z'\nbounds = { sphere = 1.5 }\n",
    "[surface]\nformula = 'sum(balls, exp(-60*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - 0.5'\n"
    "bounds = { sphere = 1.5 }\n[arrays.balls]\ncount = 700\ncx = 'sin(i*1.7)*(1 - i/700)'\n"
    "cy = 'cos(i*2.3)*(1 - i/700)'\ncz = 'sin(i*0.9 + 1)*0.8'\n",
    "[surface]\nuse = 'cayley'\n[[sections]]\nnormal = [1, 0.2, 0.1]\noffset = 0.1\n"
    "[material]\nreflection = 'self'\n[[lights]]\ndirection = [1, 2, 3]\nshadow = true\n",
    "[surface]\nuse = 'goursat'\n[material]\ntransmission = 0.8\n",
};

// One whose march takes its gradient.
std::string long_scene() {
    std::string formula = "x^2 + y^2 + z^2 - 0.5";
    for (int k = 1; k <= 30; ++k)
        formula += fmt::format(" + 0.002*exp(sin({0}*x)*cos({0}*y + z))*cos({0}*z)", k);
    return "[surface]\nformula = '" + formula + "'\nbounds = { sphere = 1 }\n";
}

class Branches : public Drawing {
protected:
    Picture drawn(const scene::Scene& scene, StageChoice stage, bool branches,
                  std::optional<MarchPlan> plan = {}) {
        RenderOptions options{96, 80, every_channel, plan};
        options.stage = stage;
        options.branches = branches;
        Renderer renderer(*context, scene, options);
        return renderer.draw(scene::at_frame(scene, 1));
    }

    // To the bit where a processor draws; a card's compiler may round two texts differently.
    void expect_same(const Picture& plain, const Picture& branching) {
        EXPECT_GT(count(plain, Verdict::hit), 500);
        if (context->info().software) {
            EXPECT_EQ(plain.verdicts, branching.verdicts);
            EXPECT_EQ(plain.evaluations(), branching.evaluations());
            EXPECT_TRUE(same_bits(plain.frame, branching.frame));
            return;
        }
        for (std::size_t k = 0; k < plain.verdicts.size(); ++k)
            EXPECT_NEAR(double(plain.verdicts[k]), double(branching.verdicts[k]), 2);
        EXPECT_NEAR(double(plain.evaluations()), double(branching.evaluations()),
                    1e-2 * double(plain.evaluations()));
    }
};
ISOMOTION_ON_EVERY_BACKEND(Branches);

TEST_P(Branches, LeaveEndsOfRaysWhereTheyAre) {
    for (const std::string& text : met_by_branches) {
        SCOPED_TRACE(text);
        const scene::Scene scene = scene_of(text);
        for (const StageChoice stage : {StageChoice::fragment, StageChoice::compute}) {
            if (stage == StageChoice::compute && !gpu::has_compute(context->info())) continue;
            expect_same(drawn(scene, stage, false), drawn(scene, stage, true));
        }
    }
}

// Compute shaders settle blocks where beams are asked for. Rays that take several passes.
TEST_P(Branches, LeaveThemInSettledBlocksAndInSeveralPasses) {
    if (!gpu::has_compute(context->info())) GTEST_SKIP() << "no compute shaders";
    const std::string beams = "[isolation]\nbeam = true\n";
    for (const std::string& text :
         {sphere_scene + beams, "[surface]\nuse = 'barth_sextic'\n" + beams, long_scene()}) {
        SCOPED_TRACE(text);
        const scene::Scene scene = scene_of(text);
        for (const std::optional<MarchPlan> plan :
             {std::optional<MarchPlan>(), std::optional(MarchPlan{33, 17, 3})}) {
            expect_same(drawn(scene, StageChoice::compute, false, plan),
                        drawn(scene, StageChoice::compute, true, plan));
        }
    }
}

} // namespace
} // namespace isomotion::render
