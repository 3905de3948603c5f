// Quotients by powers, rewritten: they have the values and slopes that they had, in narrower
// enclosures.
#include "topology/field/reciprocals.h"

#include <cmath>

#include <gtest/gtest.h>

#include "formula/evaluate/evaluate.h"
#include "formula/graph/derivative.h"
#include "formula/graph/program.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::Interval;
using formula::NodeId;

Interval over(Graph& graph, NodeId root, const Interval& x) {
    const formula::Program program = formula::schedule(graph, std::array{root});
    Interval value;
    formula::Evaluator<Interval>(program).point({}, {&x, 1}, {&value, 1});
    return value;
}

NodeId slope(Graph& graph, NodeId root) {
    return formula::differentiate_inputs(graph, root, {graph.constant(1)},
                                         formula::Slopes::generalized);
}

// 3/(1 + x^2)^n.
NodeId bell(Graph& graph, int n) {
    const NodeId x = graph.input(0);
    const NodeId divisor = graph.add(graph.constant(1), graph.multiply(x, x));
    return graph.divide(graph.constant(3), graph.integer_power(divisor, n));
}

TEST(Reciprocals, EncloseSlopesOfBellsMoreNarrowly) {
    for (const int n : {2, 3, 4, 6}) {
        Graph graph;
        const NodeId whole = bell(graph, n), rewritten = with_reciprocals(graph, whole);
        ASSERT_NE(whole, rewritten);
        const NodeId once = slope(graph, rewritten), of_whole = slope(graph, whole);
        const NodeId twice = slope(graph, once), of_whole_twice = slope(graph, of_whole);
        for (double middle = -2; middle <= 2; middle += 0.25) {
            const Interval x(middle - 0.1, middle + 0.1);
            const Interval first = over(graph, once, x), second = over(graph, twice, x);
            EXPECT_LE(width(first), width(over(graph, of_whole, x)) * (1 + 1e-12)) << n << middle;
            EXPECT_LT(width(second), width(over(graph, of_whole_twice, x))) << n << " " << middle;
            for (double at = x.lo; at <= x.hi; at += 0.01) {
                const double q = 1 + at * at;
                EXPECT_NEAR(mid(over(graph, rewritten, at)), 3 / std::pow(q, n), 1e-14);
                const double exactly = -6 * n * at / std::pow(q, n + 1);
                EXPECT_LE(first.lo, exactly + 1e-14);
                EXPECT_GE(first.hi, exactly - 1e-14);
                const double again = 6 * n * ((2 * n + 1) * at * at - 1) / std::pow(q, n + 2);
                EXPECT_LE(second.lo, again + 1e-12);
                EXPECT_GE(second.hi, again - 1e-12);
            }
        }
    }
}

TEST(Reciprocals, LeaveOtherQuotients) {
    Graph graph;
    const NodeId x = graph.input(0), other = graph.add(x, graph.constant(1));
    // A power this high clamps what it is of.
    for (const NodeId quotient : {bell(graph, 40), graph.divide(graph.constant(1), x),
                                  graph.divide(graph.constant(1), graph.multiply(x, x)),
                                  graph.divide(graph.constant(1), graph.multiply(x, other)),
                                  graph.divide(x, graph.multiply(other, other))})
        EXPECT_EQ(with_reciprocals(graph, quotient), quotient);
}

TEST(Reciprocals, HaveNoBoundBesideAPole) {
    Graph graph;
    const NodeId s = graph.add(graph.input(0), graph.constant(1));
    const NodeId pole =
        with_reciprocals(graph, graph.divide(graph.constant(1), graph.multiply(s, s)));
    const NodeId rise = slope(graph, pole), bend = slope(graph, rise);
    for (const NodeId number : {pole, rise, bend}) {
        for (const Interval near : {Interval(-2, 0), Interval(-1, 0), Interval(-1, -1 + 1e-13)})
            EXPECT_EQ(over(graph, number, near), Interval::entire()) << near.lo;
        EXPECT_TRUE(std::isfinite(over(graph, number, {-1 + 1e-5, 0}).hi));
    }
}

} // namespace
} // namespace isomotion::topology
