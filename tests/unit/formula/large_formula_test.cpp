// Formulas far beyond what anyone types: programs write such ones, and mistakes make worse.
#include "testing.h"

#include <cmath>

#include <pthread.h>

#include <fmt/format.h>

#include "formula/field.h"
#include "formula/glsl/glsl_interval.h"
#include "formula/graph/degree.h"
#include "formula/graph/derivative.h"
#include "formula/graph/limits.h"
#include "formula/graph/substitute.h"
#include "formula/hessian.h"
#include "formula/linear_sum.h"

extern "C" void __asan_init() __attribute__((weak));

namespace isomotion::formula {
namespace {

std::string repeat(std::string_view part, int times) {
    std::string text;
    for (int k = 0; k < times; ++k) text += part;
    return text;
}

class Nesting : public testing::TestWithParam<std::string> {};

TEST_P(Nesting, EndsInAnErrorAndNotInTheStack) {
    Graph graph;
    try {
        parse(graph, repeat(GetParam(), 20'000) + "x");
        FAIL() << "parsed";
    } catch (const ParseError& error) {
        EXPECT_EQ(error.message(), "the formula is nested too deeply");
        EXPECT_GT(error.column(), 100);
        EXPECT_LT(std::string_view(error.what()).size(), 400u);
    }
}

INSTANTIATE_TEST_SUITE_P(Openings, Nesting,
                         testing::Values("(", "-", "+", "2^", "2^-", "sin(", "min(x,", "pow(2,",
                                         "chebyshev(2,", "-(", "x+("));

TEST(LargeFormula, ReasonableNestingIsFine) {
    EXPECT_EQ(value_of(repeat("(", 150) + "x" + repeat(")", 150), {7, 0, 0}), 7);
    EXPECT_EQ(value_of(repeat("-", 150) + "x", {7, 0, 0}), 7);
    EXPECT_NEAR(value_of(repeat("sin(", 100) + "x" + repeat(")", 100), {1, 0, 0}), 0.1688, 1e-4);
}

// Depth that doesn't nest the text: chains of terms, and definitions upon definitions.
TEST(LargeFormula, AChainIsNotNesting) {
    EXPECT_EQ(value_of(fmt::format("x{}", repeat("+1", 50'000)), {0.5, 0, 0}), 50'000.5);
    EXPECT_EQ(value_of(fmt::format("x{}", repeat("-y", 50'000)), {0.5, 1, 0}), -49'999.5);

    std::string text = "q = x;";
    for (int k = 0; k < 2000; ++k) text += fmt::format("q = sin(q) + {};", k % 7);
    double expected = 0.25;
    for (int k = 0; k < 2000; ++k) expected = std::sin(expected) + k % 7;
    EXPECT_EQ(value_of(text + "q", {0.25, 0, 0}), expected);
}

class Large : public testing::TestWithParam<int> {};

TEST_P(Large, FieldsAreMadeAndRight) {
    const int terms = GetParam();
    std::string text = "0";
    double value = 0, slope = 0;
    const Point p{0.3, -0.2, 0.1};
    for (int k = 1; k <= terms; ++k) {
        const double w = 1 + k * 1e-4;
        text += fmt::format("+sin({}*x)*y", w);
        value += std::sin(w * p[0]) * p[1];
        slope += w * std::cos(w * p[0]) * p[1];
    }
    const Field field = make_field(text, test_vocabulary());
    EXPECT_GT(field.value.registers, 3 * terms);
    FieldEvaluator<double> evaluator(field);
    const auto bindings = test_bindings();
    EXPECT_NEAR(evaluator.value(bindings, p), value, 1e-9 * terms);
    EXPECT_NEAR(evaluator.gradient(bindings, p)[0], slope, 1e-9 * terms);
    EXPECT_NEAR(evaluator.gradient(bindings, p)[1], value / p[1], 1e-9 * terms);
    EXPECT_EQ(evaluator.gradient(bindings, p)[2], 0);
}

// ----- limits

std::string refused(std::string_view text) {
    Graph graph;
    try {
        parse(graph, text);
        return "parsed";
    } catch (const ParseError& error) {
        return error.message();
    }
}

TEST(Limits, Nesting) {
    const auto in_parentheses = [](int depth) {
        return repeat("(", depth) + "x" + repeat(")", depth);
    };
    EXPECT_EQ(refused(in_parentheses(limits::nesting / 2 - 1)), "parsed");
    EXPECT_EQ(refused(in_parentheses(limits::nesting / 2)), "the formula is nested too deeply");
    EXPECT_EQ(refused(repeat("√", 100'000) + "x"), "the formula is nested too deeply");
    EXPECT_EQ(refused(repeat("\\frac{", 50'000) + "x"), "the formula is nested too deeply");
    EXPECT_EQ(refused(repeat("-", limits::nesting - 2) + "x"), "parsed");
    EXPECT_EQ(refused(repeat("-", limits::nesting - 1) + "x"), "the formula is nested too deeply");
}

TEST(Limits, Bytes) {
    const std::string longest = "x" + std::string(limits::formula_bytes - 1, ' ');
    EXPECT_EQ(refused(longest), "parsed");
    EXPECT_EQ(refused(longest + " "), "the formula has 500001 bytes; at most 500000 are read");
}

TEST(Limits, Names) {
    const std::string longest(limits::name_bytes, 'q');
    EXPECT_EQ(refused(longest + " = x; " + longest), "parsed");
    EXPECT_EQ(refused(longest + "q = x; x"), "a name of 65 characters; at most 64 are read");
}

TEST(Limits, Nodes) {
    const std::string most = "x" + repeat("/y", int(limits::formula_nodes) - 1);
    EXPECT_EQ(refused(most), "parsed");
    EXPECT_EQ(refused(most + "/y"), "the formula is too large: it has more than 100000 operations, "
                                    "names and numbers");
}

TEST(Limits, NodesOfAGraph) {
    Graph graph;
    NodeId node = graph.input(0);
    const NodeId y = graph.input(1);
    while (graph.size() < limits::graph_nodes) node = graph.binary(Op::divide, node, y);
    EXPECT_THROW(graph.binary(Op::divide, node, y), std::length_error);
    EXPECT_EQ(graph.input(1), y); // what there is stays
    EXPECT_EQ(graph.size(), limits::graph_nodes);
}

TEST(Limits, ChebyshevDegrees) {
    EXPECT_EQ(refused("chebyshev(1000, x)"), "parsed");
    EXPECT_THAT(refused("chebyshev(1001, x)"), testing::HasSubstr("integer from 0 to 1000"));
}

// Shared parts must not be taken apart once for each way that leads to them: 2^200 here.
TEST(LargeFormula, SharedPartsAreWalkedOnce) {
    std::string text = "q = sum(links, (x-px)^2);";
    for (int k = 0; k < 200; ++k) text += "q = q*a + q*b;";
    Vocabulary one_array = test_vocabulary();
    one_array.arrays = {{"links", {{"px", {}}}}};
    const Field field = make_field(text + "q - 1", one_array);
    EXPECT_TRUE(linear_sum(field));
    EXPECT_EQ(degree(field.graph, field.root), 2);
    EXPECT_GT(glsl_gradient(field).size(), 0u);
}

// Whatever walks a graph needs little of a stack, and the parser what its depth takes.
struct Work {
    void (*run)();
    std::string failure;
};

void* on_thread(void* argument) {
    Work& work = *static_cast<Work*>(argument);
    try {
        work.run();
    } catch (const std::exception& error) {
        work.failure = error.what();
    }
    return nullptr;
}

std::string on_small_stack(void (*run)()) {
    // With the address sanitizer frames are many times as large. It may be in the libraries alone.
    const bool sanitized = __asan_init != nullptr;
    const std::size_t bytes = sanitized ? 4 << 20 : 512 << 10;
    Work work{run, {}};
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, bytes);
    pthread_t thread{};
    if (pthread_create(&thread, &attributes, on_thread, &work) != 0) return "no thread";
    pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
    return work.failure;
}

TEST(SmallStack, HoldsTheDeepestParse) {
    EXPECT_EQ(on_small_stack([] {
                  const int depth = limits::nesting / 2 - 1;
                  Graph graph;
                  parse(graph, repeat("min(x,", depth) + "x" + repeat(")", depth));
                  parse(graph, repeat("sin(", depth) + "x" + repeat(")", depth));
                  parse(graph, repeat("(", depth) + "x" + repeat(")", depth));
                  parse(graph, repeat("2^", limits::nesting - 3) + "x");
              }),
              "");
    EXPECT_THAT(on_small_stack([] {
                    Graph graph;
                    parse(graph, repeat("pow(2,", 20'000));
                }),
                testing::HasSubstr("nested too deeply"));
}

TEST(SmallStack, HoldsEveryWalkOfADeepGraph) {
    EXPECT_EQ(on_small_stack([] {
                  std::string text = "sum(links, (x-px)^2)";
                  for (int k = 0; k < 10'000; ++k) text += fmt::format("*a/{}.5+sin(x)", k + 1);
                  Vocabulary one_array = test_vocabulary();
                  one_array.arrays = {{"links", {{"px", {}}}}};
                  const Field field = make_field(text, one_array);
                  linear_sum(field);
                  degree(field.graph, field.root);
                  hessian(field);
                  const EnclosurePrograms programs = enclosure_programs(field);
                  glsl_gradient(field);
                  glsl_gradient_interval(programs, field.packing);
                  Graph copy;
                  substitute(copy, field.graph, std::array{field.root},
                             [](Graph&, const Node&, NodeId rebuilt) { return rebuilt; });
              }),
              "");
}

// A term is a product, a sine, a product and a sum.
INSTANTIATE_TEST_SUITE_P(Nodes, Large, testing::Values(500, 12'500));

} // namespace
} // namespace isomotion::formula
