#include "testing.h"

#include <cmath>
#include <limits>
#include <set>

namespace isomotion::formula::graph_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Operations (nodes with operands) needed for all of `roots`.
int operations(const Graph& graph, const std::vector<NodeId>& roots) {
    std::set<NodeId> seen;
    std::vector<NodeId> stack = roots;
    int count = 0;
    while (!stack.empty()) {
        const NodeId id = stack.back();
        stack.pop_back();
        if (!seen.insert(id).second) continue;
        const Node& node = graph[id];
        if (node.arity > 0) ++count;
        for (int k = 0; k < node.arity; ++k) stack.push_back(node.children[std::size_t(k)]);
    }
    return count;
}

int operations(std::string_view text) {
    Graph graph;
    const NodeId root = parse(graph, text);
    return operations(graph, {root});
}

struct Pair {
    std::string first, second;
};
void PrintTo(const Pair& pair, std::ostream* out) { *out << pair.first << " | " << pair.second; }

class Same : public testing::TestWithParam<Pair> {};

TEST_P(Same, OneNode) {
    Graph graph;
    EXPECT_EQ(parse(graph, GetParam().first), parse(graph, GetParam().second));
}

INSTANTIATE_TEST_SUITE_P(Sharing, Same,
                         testing::Values(Pair{"x*y", "y*x"}, Pair{"x+y", "y+x"},
                                         Pair{"sin(x*y)", "sin(y*x)"}, Pair{"2*x", "x*2"},
                                         Pair{"x^2", "x*x"}, Pair{"x^4", "(x^2)^2"},
                                         Pair{"x^6", "(x^3)^2"}, Pair{"x^3", "x^2*x"},
                                         Pair{"pow(x,2)", "x^2"}, Pair{"x^0.5", "sqrt(x)"},
                                         Pair{"x^-2", "1/x^2"}, Pair{"abs(x)^4", "x^4"},
                                         Pair{"q = x*y; q + q", "x*y + y*x"},
                                         Pair{"sum(blobs, cx*cy)", "sum(blobs, cy*cx)"}));

INSTANTIATE_TEST_SUITE_P(
    Simplified, Same,
    testing::Values(Pair{"x+0", "x"}, Pair{"0+x", "x"}, Pair{"x-0", "x"}, Pair{"x*1", "x"},
                    Pair{"x/1", "x"}, Pair{"0-x", "-x"}, Pair{"x*0", "0"}, Pair{"0/x", "0"},
                    Pair{"x-x", "0"}, Pair{"--x", "x"}, Pair{"-1*x", "-x"}, Pair{"x+-y", "x-y"},
                    Pair{"-x+y", "y-x"}, Pair{"x--y", "x+y"}, Pair{"-(x-y)", "y-x"},
                    Pair{"-x*-y", "x*y"}, Pair{"-x*y", "-(x*y)"}, Pair{"2*(3*x)", "6*x"},
                    Pair{"x*2*3", "6*x"}, Pair{"abs(-x)", "abs(x)"}, Pair{"abs(abs(x))", "abs(x)"},
                    Pair{"x^1", "x"}, Pair{"x^0", "1"}, Pair{"min(x,x)", "x"},
                    Pair{"chebyshev(0,x)", "1"}, Pair{"chebyshev(1,x)", "x"},
                    Pair{"sum(blobs,0)", "0"}, Pair{"2^10", "1024"},
                    Pair{"sqrt(2)^2-sqrt(2)^2", "0"}, Pair{"0*-1", "0"}, Pair{"-0.0", "0"}));

// What rounding alone makes negative would have no power.
INSTANTIATE_TEST_SUITE_P(
    PowersOfWhatIsNotNegative, Same,
    testing::Values( // Ties are decided as before: min takes its second operand, max its first.
        Pair{"(x-min(x,y))^a", "max(x-y,0)^a"}, Pair{"(x-min(y,x))^a", "max(0,x-y)^a"},
        Pair{"(x-max(x,y))^a", "min(x-y,0)^a"}, Pair{"(x-max(y,x))^a", "min(0,x-y)^a"},
        Pair{"(min(x,y)-x)^a", "min(0,y-x)^a"}, Pair{"(min(y,x)-x)^a", "min(y-x,0)^a"},
        Pair{"(max(x,y)-x)^a", "max(0,y-x)^a"}, Pair{"(max(y,x)-x)^a", "max(y-x,0)^a"},
        Pair{"(1-min(1,x))^1.5", "max(1-x,0)^1.5"}, Pair{"(-min(1,x)+1)^1.5", "max(1-x,0)^1.5"},
        Pair{"(1-cos(x))^1.5", "max(0,1-cos(x))^1.5"},
        Pair{"(sin(x)*tanh(y)+1)^y^0", "sin(x)*tanh(y)+1"},
        Pair{"(sin(x)*tanh(y)+1)^0.3", "max(0,sin(x)*tanh(y)+1)^0.3"},
        Pair{"(2*(1-min(1,x)))^1.5", "(2*max(1-x,0))^1.5"},
        Pair{"(3-2*min(1.5,x))^a", "(2*max(1.5-x,0))^a"},
        Pair{"(2*y-2*min(y,x))^a", "(2*max(y-x,0))^a"},
        Pair{"((1-min(1,x))*(1-cos(y))/3)^a", "(max(1-x,0)*max(0,1-cos(y))/3)^a"},
        Pair{"((1-min(1,x^2))+abs(y))^a", "(max(1-x^2,0)+abs(y))^a"},
        Pair{"(abs(x)-x)^a", "(2*max(0,-x))^a"}, Pair{"(abs(x)+x)^a", "(2*max(0,x))^a"},
        Pair{"(x+abs(x))^a", "(2*max(0,x))^a"}, Pair{"log(abs(x)-x)", "log(2*max(0,-x))"},
        Pair{"(2-2*cos(x))^a", "max(0,2-2*cos(x))^a"},
        Pair{"(0.5+0.5*sin(x)*cos(y))^a", "max(0,0.5+0.5*sin(x)*cos(y))^a"},
        Pair{"log(1-cos(x))", "log(max(0,1-cos(x)))"}));

class Different : public testing::TestWithParam<Pair> {};

TEST_P(Different, TwoNodes) {
    Graph graph;
    EXPECT_NE(parse(graph, GetParam().first), parse(graph, GetParam().second));
}

INSTANTIATE_TEST_SUITE_P(
    Kept, Different,
    testing::Values(Pair{"x-y", "y-x"}, Pair{"x/y", "y/x"}, Pair{"x^y", "y^x"}, Pair{"x", "a"},
                    // The derivative of min and max decides ties by order.
                    Pair{"min(x,y)", "min(y,x)"}, Pair{"abs(x)^3", "x^3"},
                    Pair{"sum(blobs,1)", "sum(links,1)"}, Pair{"sum(blobs,cx)", "sum(blobs,cy)"},
                    Pair{"chebyshev(3,x)", "chebyshev(4,x)"}, Pair{"sum(blobs,x)", "x"},
                    // 0/0 and infinity - infinity are NaN and stay that.
                    Pair{"x/x", "1"}));

// A choice would drop what has no value; and what rounding can't make negative stays as it is.
TEST(Graph, BasesOfPowersStayAsTheyAre) {
    for (const std::string base :
         {"1-cos(log(x))", "log(x)-min(y,log(x))", "1-min(1,x/y)", "1-cos(x^a)", "1-min(1,x^1.5)",
          "2-cos(x)", "x^2+y^2", "x^2+y^2+1", "x-y", "0.5-cos(x)", "(1-cos(x))^2"}) {
        Graph graph;
        const Node power = graph[parse(graph, "(" + base + ")^b")];
        EXPECT_EQ(power.children[0], parse(graph, base)) << base;
    }
}

TEST(Graph, PowersOfOneFormulaShareTheirProducts) {
    EXPECT_EQ(operations("x^2"), 1);
    EXPECT_EQ(operations("x^4 + x^2"), 3);
    EXPECT_EQ(operations("x^6 + x^3"), 4);
    EXPECT_EQ(operations("x^16"), 4);
    EXPECT_EQ(operations("x^15"), 6);
    // x^2, x^4 and x^6 of each of three variables: 4 products each, 8 sums.
    EXPECT_EQ(operations("x^2+x^4+x^6 + y^2+y^4+y^6 + z^2+z^4+z^6"), 3 * 4 + 8);
    EXPECT_EQ(operations("(x^2+y^2+z^2+1)^2 - 4*(x^2+y^2)"), 3 + 3 + 1 + 1 + 1);
}

TEST(Graph, IdsAscendFromChildrenToParents) {
    Graph graph;
    parse(graph, "q = x*y^7; sum(blobs, exp(q - cx)/sum(links, px)) + max(q, -z^-3)");
    for (NodeId id = 0; id < graph.size(); ++id) {
        for (int k = 0; k < graph[id].arity; ++k) {
            EXPECT_LT(graph[id].children[std::size_t(k)], id);
        }
    }
}

TEST(Graph, ArraysSayWhatANodeDependsOn) {
    Graph g;
    const NodeId e0 = g.element(0, 2), e1 = g.element(1, 0), x = g.input(0);
    EXPECT_EQ(g[x].arrays, 0u);
    EXPECT_EQ(g[e0].arrays, 1u);
    EXPECT_EQ(g[e1].arrays, 2u);
    const NodeId both = g.multiply(g.add(e0, x), e1);
    EXPECT_EQ(g[both].arrays, 3u);
    EXPECT_EQ(g[g.sum(0, both)].arrays, 2u);
    EXPECT_EQ(g[g.sum(1, g.sum(0, both))].arrays, 0u);
    EXPECT_EQ(g[g.element(max_arrays - 1, 0)].arrays, 0x80000000u);
}

TEST(Graph, ConstantsFoldByTheRules) {
    Graph g;
    const auto number = [&](double v) { return g.constant(v); };
    EXPECT_TRUE(g.is_constant(g.unary(Op::sqrt, number(-1)), 0));
    EXPECT_TRUE(g.is_constant(g.unary(Op::exp, number(1e4)), 1e300));
    EXPECT_TRUE(g.is_constant(g.divide(number(-1), number(0)), -1e300));
    EXPECT_TRUE(g.is_constant(g.binary(Op::power, number(0), number(0)), 1));
    EXPECT_TRUE(g.is_constant(g.binary(Op::power, number(-2), number(3)), -8));
    EXPECT_TRUE(g.is_constant(g.unary(Op::floor, number(-0.5)), -1));
    EXPECT_EQ(g.select(number(1), number(2), g.input(0), g.input(1)), g.input(0));
    EXPECT_EQ(g.select(number(2), number(2), g.input(0), g.input(1)), g.input(1));
    EXPECT_EQ(g.select(g.input(2), number(2), g.input(0), g.input(0)), g.input(0));
}

TEST(Graph, OneZero) {
    Graph g;
    EXPECT_EQ(g.constant(-0.0), g.constant(0.0));
    EXPECT_FALSE(std::signbit(g[g.constant(-0.0)].value));
    EXPECT_FALSE(std::signbit(g[g.unary(Op::negate, g.constant(0))].value));
    EXPECT_EQ(g.multiply(g.constant(-1), g.constant(0)), g.constant(0));
}

// Simplification may not turn a constant without a value into one with a value.
TEST(Graph, NaNStaysNaN) {
    Graph g;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const NodeId none = g.constant(nan), zero = g.constant(0), huge = g.constant(infinity);
    const auto is_nan = [&](NodeId id) { return g.is_constant(id) && std::isnan(g[id].value); };
    EXPECT_TRUE(is_nan(none));
    EXPECT_TRUE(is_nan(g.multiply(zero, none)));
    EXPECT_TRUE(is_nan(g.divide(zero, none)));
    EXPECT_TRUE(is_nan(g.subtract(none, none)));
    EXPECT_TRUE(is_nan(g.subtract(huge, huge)));
    EXPECT_TRUE(is_nan(g.divide(zero, zero)));
    EXPECT_TRUE(is_nan(g.unary(Op::log, g.constant(-1))));
    EXPECT_TRUE(is_nan(g.unary(Op::sign, none)));
    EXPECT_TRUE(is_nan(g.unary(Op::abs, none)));
    EXPECT_TRUE(is_nan(g.unary(Op::exp, none)));
    EXPECT_TRUE(is_nan(g.binary(Op::power, g.constant(-2), g.constant(0.5))));
}

TEST(Graph, ConstantFactorsDoNotGatherIntoInfinity) {
    EXPECT_EQ(value_of("1e200*(1e200*x)", {0, 0, 0}), 0);
    EXPECT_EQ(value_of("1e-200*(1e200*(1e200*x))", {1, 0, 0}), 1e200);
}

TEST(Graph, IntegerPowersOfEveryBase) {
    Graph g;
    for (const int n : {-256, -25, -3, 0, 1, 2, 24, 25, 30, 200, 256}) {
        EXPECT_TRUE(g.is_constant(g.integer_power(g.constant(1), n), 1)) << n;
        for (const double base : {0.875, -0.875}) {
            const double expected = std::pow(base, n);
            const double value = value_of(g, g.integer_power(g.input(0), n), {base, 0, 0});
            EXPECT_NEAR(value, expected, 1e-13 * std::abs(expected)) << n;
        }
    }
}

// What is no number stands for the entire line: the lesser of it and 5 may be anything below.
TEST(Graph, FoldsNoEntireLineExactly) {
    Graph g;
    g.fold_exactly();
    const NodeId line = g.constant(std::numeric_limits<double>::quiet_NaN()), five = g.constant(5);
    const auto is_number = [&](NodeId id) { return g.is_constant(id) && !std::isnan(g[id].value); };
    for (const Op op : {Op::add, Op::subtract, Op::divide, Op::min, Op::max, Op::power}) {
        for (const NodeId other : {five, line}) {
            EXPECT_FALSE(is_number(g.binary(op, line, other))) << name(op);
            EXPECT_FALSE(is_number(g.binary(op, other, line))) << name(op);
        }
    }
    for (const Op op : {Op::abs, Op::sign, Op::floor, Op::sqrt, Op::negate})
        EXPECT_FALSE(is_number(g.unary(op, line))) << name(op);
    EXPECT_FALSE(g.is_constant(g.select(line, five, five, g.constant(6))));
    EXPECT_FALSE(g.is_constant(g.select(five, line, five, g.constant(6))));
}

TEST(Graph, EveryOperationHasAName) {
    std::set<std::string_view> names;
    for (int op = 0; op <= int(Op::which); ++op) names.insert(name(Op(op)));
    EXPECT_EQ(names.size(), std::size_t(Op::which) + 1);
    EXPECT_FALSE(names.contains(""));
}

} // namespace
} // namespace isomotion::formula::graph_test
