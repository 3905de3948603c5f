#include "formula/graph/same_signs.h"

#include "testing.h"

namespace isomotion::formula {
namespace {

// What is left of a formula, as the graph of another text.
void expect_left(const std::string& text, const std::string& left) {
    SCOPED_TRACE(text);
    Graph graph;
    const NodeId root = parse(graph, text), wanted = parse(graph, left);
    EXPECT_EQ(same_signs(graph, root), wanted);
}

TEST(SameSigns, LeaveOutWhatIsAbove0) {
    expect_left("x*exp(-(x^2 + y^2))", "x");
    expect_left("3*(x*y - z)*exp(x)*cosh(y)", "3*(x*y - z)");
    expect_left("(x - y)/exp(z)", "x - y");
    expect_left("-(x*exp(y))", "-x");
    expect_left("(1 + tanh(9*x))*(y + z)", "y + z");
    expect_left("(exp(x) + exp(y))*z", "z");
    expect_left("x*exp(y)/y", "x/y");
}

TEST(SameSigns, CompareArguments) {
    expect_left("exp(x) - exp(y*z)", "x - y*z");
    expect_left("exp(x)*exp(a) = exp(y)", "x + a - y");
    expect_left("tanh(x^2) - tanh(y)", "x^2 - y");
}

TEST(SameSigns, KeepWhatTheyMust) {
    for (const char* text :
         {"exp(x) - 2", "x*sinh(y)", "x*(1 - tanh(y))*0 + z", "exp(x)", "x*exp(log(y))",
          "x*exp(1/y)", "x*sqrt(y)", "sum(blobs, exp(-(x - cx)^2)) - 1", "tanh(x) - exp(y)",
          "(0.5 + tanh(x))*y", "x*abs(y)", "tanh(tan(x)) - tanh(y)",
          "tanh(x*abs(x)^-1.5) - tanh(y)"})
        expect_left(text, text);
}

// A node that many paths lead to is looked at once.
TEST(SameSigns, TakeSharedNodesOnce) {
    std::string text = "z";
    for (int k = 0; k < 9; ++k) text = "((" + text + ")^16 + exp(x))";
    expect_left("y*" + text, "y*" + text);
    std::string positive = "exp(x)";
    for (int k = 0; k < 9; ++k) positive = "(" + positive + "^16 + exp(y))";
    expect_left("z*" + positive, "z");
}

TEST(SameSigns, AreThoseOfTheFormulaAtRandomPoints) {
    constexpr int seed = 7;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> coordinate(-2, 2);
    for (const char* text :
         {"(x^2 + y^2 - z)*exp(-(x^2 + y^2 + z^2))", "2*exp(-x^2)*(y - z)/cosh(x*y)",
          "3*exp(-(x - 1)^2) - exp(-(x + y)^2)*exp(z)", "tanh(x + y) - tanh(3*z)",
          "-(x - y)*(2 - tanh(z))*(1 + exp(x))"}) {
        SCOPED_TRACE(text);
        Graph graph;
        const NodeId root = parse(graph, text), left = same_signs(graph, root);
        EXPECT_NE(root, left);
        for (int k = 0; k < 200; ++k) {
            const Point p{coordinate(random), coordinate(random), coordinate(random)};
            EXPECT_EQ(value_of(graph, root, p) < 0, value_of(graph, left, p) < 0);
        }
    }
}

} // namespace
} // namespace isomotion::formula
