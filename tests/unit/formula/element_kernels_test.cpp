// Which sums have terms that are kernels of a distance.
#include "formula/element_kernels.h"

#include "testing.h"

namespace isomotion::formula {
namespace {

std::optional<ElementKernels> kernels_of(const std::string& text) {
    return element_kernels(make_field(text, test_vocabulary()), 0);
}

TEST(ElementKernels, AreFoundHoweverTheyAreWritten) {
    for (const char* text : {
             "sum(blobs, exp(-a*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - 1",
             "sum(blobs, exp(a*(2*x*cx + 2*y*cy + 2*z*cz - x^2 - y^2 - z^2 - cx^2 - cy^2 - cz^2))) "
             "- 1",
             "1 - sum(blobs, weight*max(0, 1 - ((x-cx)^2 + (y-cy)^2 + (z-cz)^2)/r^2)^3)",
             "1 - sum(blobs, max(0, r - sqrt((x-cx)^2 + (y-cy)^2 + (z-cz)^2))^2)",
             "sum(blobs, 1/((x-cx-b*r)^2 + (y-cy)^2 + (z-cz)^2 + 0.01)) - 1",
             "sum(blobs, max(0, 1 - (r*(x-cx) + s*(y-cy))^2 - (s*(x-cx) + r*(y-cy))^2"
             " - (z-cz+s*(x-cx))^2)^2) - 1",
             // the place beside the polynomial, too
             "sum(blobs, (x-cx)*exp(-((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - 1",
             // any expression of sums
             "log(sum(blobs, exp(-((x-cx)^2 + (y-cy)^2 + (z-cz)^2)))/(1 + sum(blobs,"
             " exp(-((x-cx)^2 + 2*(y-cy)^2 + (z-cz)^2))))) - max(x, y)",
         }) {
        const auto kernels = kernels_of(text);
        ASSERT_TRUE(kernels) << text;
        EXPECT_EQ(kernels->quadric_of.size(), kernels->terms.outputs.size()) << text;
        EXPECT_EQ(kernels->coefficients.outputs.size(),
                  std::size_t(kernels->quadrics * ElementKernels::coefficients_each))
            << text;
    }
    EXPECT_EQ(kernels_of("sum(blobs, weight*exp(-((x-cx)^2 + (y-cy)^2 + (z-cz)^2)))"
                         "/sum(blobs, exp(-((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - 1")
                  ->quadrics,
              1);
}

TEST(ElementKernels, OthersAreNone) {
    for (const char* text : {
             "x^2 + y^2 - 1",                                                       // no sum
             "sum(blobs, abs(x-cx) + abs(y-cy) + abs(z-cz)) - 1",                   // no square
             "sum(blobs, exp(-x*cx - y*cy - z)) - 1",                               // without end
             "sum(blobs, sin(cx*x)) - 1",                                           //
             "sum(links, exp(-(x-px)^2 - (y-py)^2 - z^2)) - 1",                     // another array
             "sum(blobs, sum(links, exp(-(x-cx-px)^2 - (y-cy)^2 - (z-cz)^2))) - 1", // one in
                                                                                    // another
         }) {
        EXPECT_FALSE(kernels_of(text)) << text;
    }
}

TEST(ElementKernels, OfVeryManySumsAreNone) {
    std::string text = "0";
    for (std::size_t k = 0; k < ElementKernels::most_sums; ++k)
        text += " + sum(blobs, exp(-((x-cx)^2 + (y-cy)^2 + (z-cz)^2 + " + std::to_string(k) + ")))";
    EXPECT_TRUE(kernels_of(text));
    EXPECT_FALSE(kernels_of(text + " + sum(blobs, exp(-((x-cx)^2 + (y-cy)^2 + 2*(z-cz)^2)))"));
}

// The coefficients make up the polynomial, and the terms the sum.
TEST(ElementKernels, MakeUpTheTerms) {
    const auto field = make_field(
        "sum(blobs, weight*exp(-a*((x-cx)^2 + 2*(y-cy)^2 + (z-cz+x)^2))*r)", test_vocabulary());
    const auto kernels = element_kernels(field, 0);
    ASSERT_TRUE(kernels);
    Bindings<double> one = test_bindings(1);
    const Point p{0.3, -0.7, 0.4};
    std::vector<double> fields;
    for (const int f : kernels->fields) fields.push_back(one.arrays[0].fields[std::size_t(f)][0]);
    std::array<double, 10> q{};
    Evaluator<double>(kernels->coefficients).point(one, fields, q);
    const double value = q[0] + q[1] * p[0] + q[2] * p[1] + q[3] * p[2] +
                         0.5 * (q[4] * p[0] * p[0] + q[7] * p[1] * p[1] + q[9] * p[2] * p[2]) +
                         q[5] * p[0] * p[1] + q[6] * p[0] * p[2] + q[8] * p[1] * p[2];
    std::vector<Interval> inputs{p[0], p[1], p[2], value};
    for (const double f : fields) inputs.emplace_back(f);
    Interval term;
    Evaluator<Interval>(kernels->terms).point(convert<Interval>(one), inputs, {&term, 1});
    EXPECT_NEAR(mid(term), run(field.value, p, one), 1e-12);
}

} // namespace
} // namespace isomotion::formula
