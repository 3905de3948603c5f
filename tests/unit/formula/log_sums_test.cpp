#include "formula/graph/log_sums.h"

#include "formula/graph/operations.h"
#include "in_range.h"

namespace isomotion::formula {
namespace {

// max(-1e30, min(m, 1e30)): an infinite exponent is not subtracted from itself.
TEST(LogSums, AreTakenFromTheLargestExponent) {
    const auto cut = [](const std::string& m) {
        const double end = Operations<float>::saturation();
        return fmt::format("max({0}, min({1}, {2}))", -end, m, end);
    };
    const auto expect = [&](const std::string& text, const std::string& m, const char* wanted) {
        expect_in_range(text, fmt::format(fmt::runtime(wanted), cut(m)));
    };
    expect("log(exp(x) + exp(y))", "max(x, y)", "{0} + log(exp(x - {0}) + exp(y - {0}))");
    expect("log(1 + exp(x))", "max(0, x)", "{0} + log(exp(-{0}) + exp(x - {0}))");
    expect("log(cosh(x))", "max(x, -x)", "{0} + log(0.5*exp(x - {0}) + 0.5*exp(-x - {0}))");
}

// What may be 0 would leave nothing of the largest exponential, and all others 0.
TEST(LogSums, KeepWhereAFactorMayBe0) {
    for (const char* text :
         {"log(1 + a*exp(9*y))", "log(x^2 + exp(y))", "log(1 + max(0, x)*exp(y))",
          "log(1 + exp(y)/(1 + exp(y)))", "log(0*x + 3)"})
        expect_in_range(text, text);
}

// The input that stands for m would be taken out of the loop.
TEST(LogSums, KeepThoseOfEachElement) {
    const char* text = "sum(blobs, log(exp(x) + exp(cx))) - 1";
    expect_in_range(text, text);
}

TEST(LogSums, KeepWhatHasNoExponentials) {
    for (const char* text : {"log(x^2 + y^2) + z", "exp(x) + exp(y) - 1", "log(sinh(x) + 2)",
                             "log(sum(blobs, exp(-(x - cx)^2)))", "log(x^y)", "exp(log(x) + y)",
                             "log(exp(x) + sum(blobs, exp(cx)))"})
        expect_in_range(text, text);
}

constexpr std::array equal_on_paper{
    "log(exp(x) + exp(y) + exp(z))/3",
    "-log(4*exp(-3*x)*exp(y^2) + 2*exp(y - z) + 3)",
    "log(2^x + 2^(-y) + 0.1*exp(z))/log(2)",
    "log(cosh(x - y) + 2)*z",
    "log(exp(2*x)/exp(y) - exp(2*x - 3)/exp(y))",
    "max(z, log(exp(x) + log(exp(y) + exp(z)) + 9) - log(exp(x) + 1))",
    "log(exp(log(exp(3*x) + 1) - z) + exp(y))",
};

TEST(LogSums, AreEqualOnPaper) {
    for (const char* text : equal_on_paper) expect_equal_on_paper(text);
}

// exp(-100*0.9) is 0 in float32, and exp(100*0.9) beyond its cut-off.
TEST(LogSums, HoldInFloats) {
    const Field blend = make_field("-log(exp(-100*x) + exp(-100*y))/100", {});
    const Field even = make_field("log(cosh(100*x))/100", {});
    for (const float x : {-30.0f, -0.9f, -0.5f, 0.0f, 0.9f, 30.0f}) {
        for (const float y : {-20.0f, -0.91f, 0.0f, 0.92f, 20.0f}) {
            EXPECT_NEAR(FieldEvaluator<float>(blend).value({}, {x, y, 0}), std::min(x, y), 0.007);
            const auto slope = FieldEvaluator<float>(blend).gradient({}, {x, y, 0});
            EXPECT_NEAR(slope[0] + slope[1], 1, 1e-5) << x << ' ' << y;
        }
        EXPECT_NEAR(FieldEvaluator<float>(even).value({}, {x, 0, 0}), std::abs(x), 0.007);
        EXPECT_NEAR(FieldEvaluator<float>(even).gradient({}, {x, 0, 0})[0], std::tanh(100 * x),
                    1e-5);
    }
}

TEST(LogSums, OfElementsMayFade) {
    Graph graph;
    const auto fades = [&](const char* text) { return has_fading_logs(graph, parse(graph, text)); };
    EXPECT_TRUE(fades("x - log(0.1 + 2*sum(blobs, r*exp(-(x - cx)^2)))"));
    EXPECT_FALSE(fades("sum(blobs, exp(-(x - cx)^2)) - log(x)"));
    EXPECT_FALSE(fades("log(sum(blobs, (x - cx)^2)) + exp(x)"));
    EXPECT_FALSE(fades("log(exp(x) + exp(y))"));
}

TEST(LogSums, TakeSharedNodesInShortTime) {
    Graph graph;
    NodeId sum = parse(graph, "exp(x)"), product = parse(graph, "exp(y)");
    const NodeId z = parse(graph, "z");
    for (int k = 0; k < 40; ++k) {
        const NodeId less = graph.subtract(sum, graph.constant(k + 0.5));
        sum = graph.add(less, graph.multiply(z, graph.add(sum, graph.constant(k))));
        sum = graph.add(sum, graph.subtract(less, z));
        product = graph.multiply(product, product);
    }
    expect_few_new_nodes(graph, graph.unary(Op::log, graph.add(sum, product)));
}

} // namespace
} // namespace isomotion::formula
