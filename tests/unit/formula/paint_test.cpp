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

// F's fields stay where they are; what a paint reads more is stored behind them.
TEST(Paint, MayReadAnyFieldOfAnArray) {
    const Paint more = paint("sum(blobs, s*cx*weight) + sum(links, px)");
    ASSERT_EQ(field().packing, (ArrayPacking{{2, 3}, {}}));
    const Field both = with_elements_of(field(), more.value);
    EXPECT_EQ(both.packing, (ArrayPacking{{2, 3, 0, 5}, {0}}));
    EXPECT_EQ(with_elements_of(both, paint("sum(blobs, cy*cx)").value).packing,
              (ArrayPacking{{2, 3, 0, 5, 1}, {0}}));
    const Bindings<double> bindings = test_bindings();
    double value = 0, expected = 0;
    Evaluator<double>(more.value).point(bindings, std::vector<double>(10, 0.5), {&value, 1});
    const auto& blobs = bindings.arrays[0].fields;
    for (std::size_t i = 0; i < 3; ++i) expected += blobs[5][i] * blobs[0][i] * blobs[3][i];
    for (const double px : bindings.arrays[1].fields[0]) expected += px;
    EXPECT_NEAR(value, expected, 1e-14);
}

std::array<double, 3> color_at(const Paint& color) {
    std::array<double, 3> parts{};
    std::vector<double> inputs(paint_names.size() + 3, 0.5);
    for (std::size_t k = 0; k < 3; ++k) inputs[paint_names.size() + k] = 10 + double(k);
    Evaluator<double>(color.value).point(test_bindings(), inputs, parts);
    return parts;
}

TEST(Color, HasPartsOfItsOwnAndThoseOfTheMaterial) {
    const Paint color = make_color({"a*x", std::nullopt, "nz"}, test_vocabulary(), field());
    EXPECT_EQ(color_at(color), (std::array{0.625, 11.0, 0.5}));
    EXPECT_EQ(color.text, "a*x, as it is, nz");
    EXPECT_THAT(glsl_color_value(color, field().packing), testing::HasSubstr(R"(
vec3 color_value(vec3 p, vec3 n, vec2 curvature, float evaluations, vec3 own) {
    float v2 = p.x * parameters[0].x;
    return vec3(v2, own.g, n.z);
}
)"));
}

// F = ... + sum(blobs, weight*(z - cz)): the weights are the sizes of the terms.
TEST(Color, OfElementsIsTheirMean) {
    const auto color = make_mean_color(test_vocabulary(), field(), 0, {0, 4, 5}, 0.5);
    ASSERT_TRUE(color);
    const Bindings<double> bindings = test_bindings();
    const auto& blobs = bindings.arrays[0].fields;
    std::array<double, 3> sums{};
    double all = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double weight = std::abs(blobs[3][i] * (0.5 - blobs[2][i]));
        all += weight;
        for (const int k : {0, 1, 2})
            sums[std::size_t(k)] +=
                weight * blobs[std::size_t(std::array{0, 4, 5}[std::size_t(k)])][i];
    }
    const auto found = color_at(*color);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], 0.5 * sums[k] / all, 1e-14);
    EXPECT_FALSE(make_mean_color(test_vocabulary(), field(), 1, {0, 1, 2}, 1)) << "no sum over it";
}

TEST(Color, WithoutAWeightIsTheMaterials) {
    const auto color = make_mean_color(test_vocabulary(), field(), 0, {0, 4, 5}, 0.5);
    std::array<double, 3> parts{};
    std::vector<double> inputs(paint_names.size(), 0.5);
    inputs.insert(inputs.end(), {10, 11, 12});
    Evaluator<double>(color->value).point(test_bindings(0), inputs, parts);
    EXPECT_EQ(parts, (std::array{10.0, 11.0, 12.0}));
}

// A field with one value for all elements is what the mean is.
TEST(Color, OfElementsThatShareAFieldHasItsValue) {
    const Field links = make_field("sum(links, px*x) - 1", test_vocabulary());
    const auto color = make_mean_color(test_vocabulary(), links, 1, {2, 2, 0}, 1);
    EXPECT_NEAR(color_at(*color)[0], 0.125, 1e-15);
}

TEST(Paint, MistakesNameWhatWouldBeRight) {
    EXPECT_EQ(mistake("mean_curvatur"), "unknown name 'mean_curvatur'; did you mean "
                                        "'mean_curvature'?");
    EXPECT_EQ(mistake("gausian_curvature"), "unknown name 'gausian_curvature'; did you mean "
                                            "'gaussian_curvature'?");
    EXPECT_EQ(mistake("widht"), "unknown name 'widht'; did you mean 'width'?");
    EXPECT_EQ(mistake("cx"), "'cx' is a field of the array 'blobs' and has a value only inside "
                             "sum(blobs, ...)");
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
