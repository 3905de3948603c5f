// What the text of a colour shares with the text of the field.
#include <gmock/gmock.h>

#include "scenes.h"

namespace isomotion::shader {
namespace {

using testing::HasSubstr;
using testing::Not;

class AssemblePaint : public testing::Test {
protected:
    static void SetUpTestSuite() { use_shaders_of_source_tree(); }
};

// A cell's list where the colour weighs elements as the field does, all of them where it doesn't.
TEST_F(AssemblePaint, ColoursSumWhatTheirWeightsAllow) {
    const std::string term = "exp(-20*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))";
    const auto shade = [&](const std::string& part) {
        const std::string color = fmt::format("[material]\ncolor = ['{}', 0.5, 0]\n", part);
        return text_of(assemble(scene_of(blobs_text(900, every_bounds[0], "hermite") + color)),
                       Role::shade);
    };
    const std::string near = shade(fmt::format("sum(blobs, cx*{0})/sum(blobs, {0})", term));
    EXPECT_THAT(near, HasSubstr("vec3 own) {\n    enter_cell(cell_of(p));\n"));
    EXPECT_THAT(near, Not(HasSubstr("all_texel")));
    const std::string all = shade("sum(blobs, cx*x)");
    EXPECT_THAT(all, Not(HasSubstr("vec3 own) {\n    enter_cell")));
    EXPECT_THAT(all, HasSubstr("vec4 all_texel(int element, int texel) {"));
    EXPECT_THAT(all, HasSubstr("e0 < all_count"));
}

// A kernel that field and paint share is defined once.
TEST_F(AssemblePaint, PaintAndFieldShareKernels) {
    for (const std::string& formula : {std::string("exp(x) + sin(y)"), long_formula()}) {
        const Passes painted =
            assemble(scene_of(surface_text(formula) + "[material.colormap]\nrange = [0, 1]\n"
                                                      "value = 'exp(nz)*mean_curvature*sin(x)'\n"));
        EXPECT_EQ(occurrences(text_of(painted, Role::shade), "// shaders/math/exp.glsl"), 1);
        EXPECT_EQ(occurrences(text_of(painted, Role::shade), "// shaders/math/trig.glsl"), 1);
        EXPECT_EQ(occurrences(text_of(painted, Role::shade), "// shaders/math/bits.glsl"), 1);
        EXPECT_EQ(occurrences(text_of(painted, Role::shade), "uniform Parameters {"), 1);
    }
}

} // namespace
} // namespace isomotion::shader
