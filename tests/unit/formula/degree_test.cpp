#include "formula/graph/degree.h"

#include <gtest/gtest.h>

#include "formula/field.h"

namespace isomotion::formula {
namespace {

std::optional<int> degree_of(const std::string& text) {
    Vocabulary names;
    names.parameters = {"a", "n"};
    names.arrays = {{"blobs", {{"cx", {}}, {"w", {}}}}};
    const Field field = make_field(text, names);
    return degree(field.graph, field.root);
}

TEST(Degree, OfPolynomials) {
    EXPECT_EQ(degree_of("x"), 1);
    EXPECT_EQ(degree_of("a"), 0);
    EXPECT_EQ(degree_of("x*y*z - 1"), 3);
    EXPECT_EQ(degree_of("(x^2 + y^2)^3 - z^5"), 6);
    EXPECT_EQ(degree_of("-(x - a)^2/(1 + a^2) + y"), 2);
    EXPECT_EQ(degree_of("exp(a)*x + sqrt(abs(a))*y^3 + min(a, 1)*z"), 3);
    EXPECT_EQ(degree_of("a^n*x^4"), 4);
    EXPECT_EQ(degree_of("x^12*y^24"), 36);
}

// An even power needs no abs.
TEST(Degree, OfWhatAGraphMakesSimple) {
    EXPECT_EQ(degree_of("abs(x)^2"), 2);
    EXPECT_EQ(degree_of("0*sin(x) + y"), 1);
    EXPECT_EQ(degree_of("x/2"), 1);
}

TEST(Degree, OfChebyshevPolynomialsIsTheProduct) {
    EXPECT_EQ(degree_of("chebyshev(7, x)"), 7);
    EXPECT_EQ(degree_of("chebyshev(4, x^2 + y) + z"), 8);
    EXPECT_EQ(degree_of("chebyshev(0, x) + y"), 1);
    EXPECT_EQ(degree_of("chebyshev(5, a)*y"), 1);
    Graph graph;
    const NodeId x = graph.input(0);
    EXPECT_EQ(degree(graph, graph.chebyshev(7, x, 3)), 4);
}

TEST(Degree, OfSumsIsThatOfTheirTerms) {
    EXPECT_EQ(degree_of("sum(blobs, w*(x - cx)^2) - a"), 2);
    EXPECT_EQ(degree_of("x*sum(blobs, w*(x - cx)^2)^3"), 7);
    EXPECT_EQ(degree_of("sum(blobs, w/(1 + cx^2)) + x"), 1);
    EXPECT_EQ(degree_of("sum(blobs, w/(1 + (x - cx)^2))"), std::nullopt);
}

TEST(Degree, NoneOfWhatIsNoPolynomial) {
    for (const char* text : {"abs(x)", "1/x", "a/(x^2 + 1)", "x^0.5", "x^n", "a^x", "min(x, a)",
                             "max(a, y)", "exp(x)", "sqrt(x^2 + y^2)", "floor(z)", "sign(x)",
                             "sin(x)*0.5 + y", "chebyshev(3, abs(x))", "x^-2 + y"}) {
        EXPECT_EQ(degree_of(text), std::nullopt) << text;
    }
}

// x^(24^5) by nested powers: no overflow.
TEST(Degree, HasACeiling) {
    std::string text = "x";
    for (int k = 0; k < 5; ++k) text = "(" + text + ")^24";
    EXPECT_EQ(degree_of(text), 1 << 20);
}

} // namespace
} // namespace isomotion::formula
