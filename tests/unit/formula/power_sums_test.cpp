#include "formula/graph/power_sums.h"

#include "formula/graph/operations.h"
#include "in_range.h"

namespace isomotion::formula {
namespace {

std::string cut_off(const std::string& most) {
    const double end = Operations<float>::saturation();
    return fmt::format("min({}, {})", most, end);
}

TEST(PowerSums, AreTakenFromTheLargestBase) {
    const auto expect = [&](const std::string& text, const std::string& m, const char* wanted) {
        expect_in_range(text, fmt::format(fmt::runtime(wanted), cut_off(m)));
    };
    const std::string of_two = "max(max(1e-30, abs(x)), abs(y))";
    expect("(x^60 + y^60)^(1/60)", of_two, "{0}*((x/{0})^60 + (y/{0})^60)^(1/60)");
    expect("(3*x^40 + y^40/2)^0.05", of_two, "{0}^2*(3*(x/{0})^40 + 0.5*(y/{0})^40)^0.05");
    expect("(abs(x)^a + abs(y)^a)^(1/a)", "max(max(1e-30, abs(abs(x))), abs(abs(y)))",
           "{0}*((abs(x)/{0})^a + (abs(y)/{0})^a)^(1/a)");
    expect("(1 + x^20)^0.1", "max(1, abs(x))", "{0}^2*((x/{0})^20 + (1/{0})^20)^0.1");
}

// Exponents that are no inverse of each other would cost one more power, terms below 0 may cancel,
// and what is not steep stays in range as it is.
TEST(PowerSums, KeepWhatNeedsNoScale) {
    for (const char* text :
         {"(x^4 + y^4)^(1/4)", "(x^60 - y^60)^(1/60)", "(x^60 + y^58)^(1/60)", "x^60 + y^60 - 1",
          "(x^60 + y^60)^0.6", "(abs(x)^a + abs(y)^a)^b", "(abs(x)^a + abs(y)^b)^(1/a)",
          "(x^60 + y^60 - 1)^(1/60)", "(x^60 + y^60)^(-1/60)", "sum(blobs, (x^60 + cx^60)^(1/60))",
          "sum(blobs, (x - cx)^60)^(1/60)", "(x^60 + 0*y + a)^(1/60)"})
        expect_in_range(text, text);
}

TEST(PowerSums, AreEqualOnPaper) {
    for (const char* text :
         {"(x^20 + y^20 + z^20)^(1/20) - 1", "(2*x^16 + 3*abs(y)^16 + 0.5)^(1/16)*z",
          "(abs(x)^(2/c) + abs(y)^(2/c))^(c/2)", "(abs(x)^17 + abs(x - y)^17)^(1/34)",
          "(abs(x)^16.5 + (abs(y)^20 + abs(z)^20)^(1/20)^16.5)^(1/16.5)",
          "log(exp((x^20 + y^20)^(1/20)) + exp(z))", "(abs(x)^m + 1)^(1/m)"})
        expect_equal_on_paper(text);
}

// 0.1^60 is 0 in float32, and 5^60 beyond its cut-off.
TEST(PowerSums, HoldInFloats) {
    for (const char* text : {"(x^60 + y^60)^(1/60)", "(abs(x)^200 + abs(y)^200)^(1/200)",
                             "(abs(x)^a + abs(y)^a)^(1/a)"}) {
        SCOPED_TRACE(text);
        Vocabulary vocabulary;
        vocabulary.parameters = {"a"};
        const Field norm = make_field(text, vocabulary);
        Bindings<float> bindings;
        bindings.parameters = {150};
        FieldEvaluator<float> evaluator(norm);
        for (const float x : {-5.0f, -0.1f, 1e-6f, 0.02f, 1.0f, 30.0f}) {
            for (const float y : {-2.0f, -0.11f, 0.0f, 3e-6f, 0.9f, 25.0f}) {
                SCOPED_TRACE(fmt::format("({}, {})", x, y));
                const float larger = std::max(std::abs(x), std::abs(y));
                EXPECT_NEAR(evaluator.value(bindings, {x, y, 0}), larger, 0.012f * larger);
                // Euler's identity of functions of degree 1.
                const auto slope = evaluator.gradient(bindings, {x, y, 0});
                EXPECT_NEAR(x * slope[0] + y * slope[1], larger, 0.012f * larger);
            }
        }
        EXPECT_EQ(evaluator.value(bindings, {0, 0, 0}), 0);
    }
}

// Paths through shared nodes are many more than nodes.
TEST(PowerSums, TakeSharedNodesInShortTime) {
    Graph graph;
    NodeId sum = parse(graph, "x^20"), product = parse(graph, "y");
    for (int k = 0; k < 40; ++k) {
        sum = graph.add(sum, graph.multiply(graph.constant(k + 0.5), graph.add(sum, product)));
        product = graph.multiply(product, graph.multiply(product, product));
    }
    const NodeId root = graph.binary(Op::power, sum, graph.constant(0.05));
    const std::size_t before = graph.size();
    const InRange in_range(graph, root);
    in_range.complete(std::array{in_range.root()});
    EXPECT_LT(graph.size() - before, 3000u);
}

} // namespace
} // namespace isomotion::formula
