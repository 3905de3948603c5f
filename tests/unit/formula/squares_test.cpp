#include "formula/graph/squares.h"

#include "testing.h"

namespace isomotion::formula {
namespace {

bool squares(const std::string& text) {
    Graph graph;
    const NodeId root = parse(graph, text);
    return has_squares(graph, root);
}

TEST(Squares, OfCurvedFactors) {
    for (const char* text :
         {"(x^2 + y^2 - 1)^2 + z", "(x*y - z)*(x*y - z)", "z - (x*y)^4", "sin(x)^2 - y^2",
          "chebyshev(3, x)^2 + y", "abs(x)^2*y + sqrt(x^2 + 1)^6", "sum(blobs, (x^2 - cx)^2) - 1",
          "(x^2 + a)^-2 - y", "(x^2 - y)^3 + z"})
        EXPECT_TRUE(squares(text)) << text;
}

TEST(Squares, NoneOfPlanesAndProducts) {
    for (const char* text :
         {"x^2 + y^2 + z^2 - 1", "(x + 2*y - a)^2 - z^4", "x*y*z", "(x^2 + 1)*(y^2 + 1)",
          "a^2*x + (a^2 + b)^2", "x^a + sin(y)", "sum(blobs, (x - cx)^2) - 1", "sqrt(x^2 + 1)"})
        EXPECT_FALSE(squares(text)) << text;
}

} // namespace
} // namespace isomotion::formula
