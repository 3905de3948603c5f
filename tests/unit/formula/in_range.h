// Formulas whose parts are kept in range, graph/in_range.h.
#pragma once

#include <array>
#include <string>

#include "formula/graph/in_range.h"
#include "testing.h"

namespace isomotion::formula {

inline NodeId kept_in_range(Graph& graph, const std::string& text) {
    const InRange in_range(graph, parse(graph, text), Purpose::numbers);
    return in_range.complete(std::array{in_range.root()}).front();
}

// What one text becomes, as the graph of another.
inline void expect_in_range(const std::string& text, const std::string& wanted) {
    SCOPED_TRACE(text);
    Graph graph;
    const NodeId right = parse(graph, wanted);
    EXPECT_EQ(kept_in_range(graph, text), right);
}

// The same numbers at random points where nothing is out of double's range.
inline void expect_equal_on_paper(const std::string& text) {
    constexpr int seed = 11;
    SCOPED_TRACE(text + ", seed " + std::to_string(seed));
    Random random(seed);
    Graph graph;
    const NodeId root = parse(graph, text), now = kept_in_range(graph, text);
    EXPECT_NE(root, now);
    for (int k = 0; k < 100; ++k) {
        const Point p = random.point(3);
        const double exact = value_of(graph, root, p);
        EXPECT_NEAR(value_of(graph, now, p), exact, 1e-12 * (1 + std::abs(exact)));
    }
}

// Paths through shared nodes are many more than nodes.
inline void expect_few_new_nodes(Graph& graph, NodeId root) {
    const std::size_t before = graph.size();
    const InRange in_range(graph, root, Purpose::numbers);
    in_range.complete(std::array{in_range.root()});
    EXPECT_LT(graph.size() - before, 3000u);
}

} // namespace isomotion::formula
