#include "formula/paint.h"

#include "testing.h"

namespace isomotion::formula {
namespace {

const Field& field() {
    static const Field made =
        make_field("x^2 + a*y + sum(blobs, weight*(z-cz))", test_vocabulary());
    return made;
}

Paint paint(std::string_view text) { return make_paint(text, test_vocabulary(), field()); }

std::string mistake(std::string_view text) {
    try {
        paint(text);
    } catch (const ParseError& error) {
        return error.message();
    }
    return "nothing is wrong";
}

TEST(Paint, NamesMeanTheirInputs) {
    Bindings<double> bindings = test_bindings();
    const std::vector<double> inputs{2, 3, 5, 7, 11, 13, 17, 19, 23, 29};
    ASSERT_EQ(inputs.size(), paint_names.size());
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        const Paint p = paint(paint_names[k]);
        double value = 0;
        Evaluator<double>(p.value).point(bindings, inputs, {&value, 1});
        EXPECT_EQ(value, inputs[k]) << paint_names[k];
        for (const auto& name : paint_names) EXPECT_EQ(p.uses(name), name == paint_names[k]);
    }
    double value = 0;
    const Paint sum = paint("a + sum(blobs, weight*x)");
    Evaluator<double>(sum.value).point(bindings, inputs, {&value, 1});
    double expected = bindings.parameters[0];
    for (const double weight : bindings.arrays[0].fields[3]) expected += 2 * weight;
    EXPECT_NEAR(value, expected, 1e-14);
}

TEST(Paint, DerivesTwiceOnlyForACurvature) {
    EXPECT_FALSE(paint("x + nz*evaluations/t").hessian);
    EXPECT_FALSE(paint("0*mean_curvature").hessian) << "folded away";
    EXPECT_TRUE(paint("mean_curvature").hessian);
    EXPECT_TRUE(paint("abs(gaussian_curvature)^0.5").hessian);
}

TEST(Paint, ThePaintsNamesGoBeforeParameters) {
    Vocabulary vocabulary = test_vocabulary();
    vocabulary.parameters.push_back("nx");
    EXPECT_TRUE(make_paint("nx", vocabulary, field()).uses("nx"));
}

TEST(Paint, MistakesNameWhatWouldBeRight) {
    EXPECT_EQ(mistake("mean_curvatur"), "unknown name 'mean_curvatur'; did you mean "
                                        "'mean_curvature'?");
    EXPECT_EQ(mistake("gausian_curvature"), "unknown name 'gausian_curvature'; did you mean "
                                            "'gaussian_curvature'?");
    EXPECT_EQ(mistake("widht"), "unknown name 'widht'; did you mean 'width'?");
    EXPECT_EQ(mistake("cx"), "'cx' is a field of the array 'blobs' and has a value only inside "
                             "sum(blobs, ...)");
    EXPECT_EQ(mistake("sum(blobs, cx)"),
              "the surface's formula leaves out the field 'cx' of 'blobs'; only fields that it "
              "reads are there to paint with");
    EXPECT_EQ(mistake("x/0"), "division by zero");
}

TEST(Paint, IsAFunctionInGlsl) {
    EXPECT_EQ(glsl_paint_value(paint("y*nz + mean_curvature - gaussian_curvature*evaluations + t"),
                               field().packing),
              R"(uniform float paint_time;
float paint_value(vec3 p, vec3 n, vec2 curvature, float evaluations) {
    float v2 = p.y * n.z;
    float v4 = v2 + curvature.x;
    float v7 = curvature.y * evaluations;
    float v8 = v4 - v7;
    float v10 = v8 + paint_time;
    return float(v10);
}
)");
}

} // namespace
} // namespace isomotion::formula
