// Expressions with others in place of their parts: values are those of the composed functions.
#include "formula/graph/substitute.h"

#include "formula/graph/derivative.h"
#include "random_formula.h"

namespace isomotion::formula {
namespace {

NodeId as_it_is(Graph&, const Node&, NodeId rebuilt) { return rebuilt; }

TEST(NodesBelow, AreAllThatARootNeedsChildrenFirst) {
    Graph g;
    const NodeId other = parse(g, "exp(z) - b");
    const NodeId root = parse(g, "sum(blobs, cx*x)*sin(x) + min(y, chebyshev(4, x))");
    const std::vector<NodeId> below = nodes_below(g, std::array{root});
    EXPECT_EQ(below.back(), root);
    EXPECT_TRUE(std::ranges::is_sorted(below));
    EXPECT_EQ(std::ranges::adjacent_find(below), below.end());
    std::vector<bool> seen(g.size(), false);
    for (const NodeId id : below) {
        for (std::size_t k = 0; k < g[id].arity; ++k) EXPECT_TRUE(seen[g[id].children[k]]);
        seen[id] = true;
    }
    EXPECT_FALSE(seen[other]);
    // Each node but the root has some parent that is below, too.
    for (const NodeId id : below) {
        const bool has_parent = std::ranges::any_of(below, [&](NodeId parent) {
            const Node& node = g[parent];
            return std::find(node.children.begin(), node.children.begin() + node.arity, id) !=
                   node.children.begin() + node.arity;
        });
        EXPECT_EQ(has_parent, id != root);
    }
}

TEST(NodesBelow, OfNoRootsAreNone) {
    Graph g;
    parse(g, "x + 1");
    EXPECT_TRUE(nodes_below(g, {}).empty());
}

TEST(Substitute, NothingGivesTheSameNode) {
    Graph g;
    for (const char* text : {"x", "3", "a*x + b", "sum(blobs, exp(-cx*x)*sum(links, px))",
                             "chebyshev(5, x*y)", "max(abs(x), floor(y))^1.5", "atan(x)/sqrt(z)"}) {
        const NodeId root = parse(g, text);
        EXPECT_EQ(substitute(g, g, std::array{root}, as_it_is)[0], root) << text;
    }
}

TEST(Substitute, LeavesSumsWithAllThatIsBelowThem) {
    Graph g;
    const Replacement y_for_x = [](Graph& to, const Node& node, NodeId rebuilt) {
        return node.op == Op::input && node.index == 0 ? to.input(1) : rebuilt;
    };
    const auto expect = [&](const char* text, const char* wanted) {
        EXPECT_EQ(substitute_outside_sums(g, parse(g, text), y_for_x), parse(g, wanted)) << text;
    };
    expect("sum(blobs, cos(cx*x))*sin(x) + x", "sum(blobs, cos(cx*x))*sin(y) + y");
    expect("max(least(blobs, x - cx), least(blobs, x - cx, x*cy))^2 - sin(x)",
           "max(least(blobs, x - cx), least(blobs, x - cx, x*cy))^2 - sin(y)");
    expect("sum(blobs, cos(cx*x))", "sum(blobs, cos(cx*x))");
}

TEST(Substitute, KeepsSelectAndDerivativesOfChebyshev) {
    Graph g;
    const NodeId x = g.input(0), y = g.input(1);
    const NodeId root =
        g.select(x, y, g.chebyshev(7, x, 2), differentiate_inputs(g, parse(g, "x^3*y"), {x, y}));
    EXPECT_EQ(substitute(g, g, std::array{root}, as_it_is)[0], root);
    Graph other;
    const NodeId there = substitute(other, g, std::array{root}, as_it_is)[0];
    for (const Point p : {Point{0.3, 0.7, 0}, Point{0.7, 0.3, 0}})
        EXPECT_EQ(value_of(other, there, p), value_of(g, root, p));
}

TEST(Substitute, SharesWhatRootsShare) {
    Graph from, to;
    const NodeId a = parse(from, "sin(x*y) + 1"), b = parse(from, "2*sin(x*y)");
    const std::vector<NodeId> both = substitute(to, from, std::array{a, b, a}, as_it_is);
    ASSERT_EQ(both.size(), 3u);
    EXPECT_EQ(both[0], both[2]);
    std::size_t sines = 0;
    for (const NodeId id : nodes_below(to, both)) sines += to[id].op == Op::sin;
    EXPECT_EQ(sines, 1u);
}

TEST(Substitute, FoldsWhatBecomesConstant) {
    Graph g;
    const NodeId root = parse(g, "sin(a)*x + b*y");
    const auto zero = [](Graph& to, const Node& node, NodeId rebuilt) {
        return node.op == Op::parameter ? to.constant(0) : rebuilt;
    };
    EXPECT_TRUE(g.is_constant(substitute(g, g, std::array{root}, zero)[0], 0));
}

// `replacement` sees nodes as they are in `from`, not what became of them: x and y trade places.
TEST(Substitute, IsSimultaneous) {
    Graph g;
    const NodeId root = parse(g, "x - 2*y");
    const auto trade = [](Graph& to, const Node& node, NodeId rebuilt) {
        return node.op == Op::input ? to.input(1 - node.index) : rebuilt;
    };
    EXPECT_EQ(substitute(g, g, std::array{root}, trade)[0], parse(g, "y - 2*x"));
}

// An inner node is replaced with all that is below it.
TEST(Substitute, ReplacesWholeSums) {
    Graph g;
    const NodeId root = parse(g, "sum(blobs, exp(cx*x)) + sum(links, px)*y");
    const auto count = [](Graph& to, const Node& node, NodeId rebuilt) {
        return node.op == Op::sum ? to.constant(node.index + 1) : rebuilt;
    };
    EXPECT_EQ(substitute(g, g, std::array{root}, count)[0], parse(g, "1 + 2*y"));
}

// Values: f(p(x), q(x), r(x)) by substitution is f at (p, q, r).
TEST(Substitute, ComposesRandomFormulas) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        FormulaGenerator generator(seed);
        const RandomFormula outer = generator.make(4);
        std::array<RandomFormula, 3> inner;
        for (RandomFormula& each : inner) each = generator.make(2);
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + outer.text);
        Graph from, to;
        const NodeId root = parse(from, outer.text);
        std::array<NodeId, 3> stands_for{};
        for (std::size_t k = 0; k < 3; ++k) stands_for[k] = parse(to, inner[k].text);
        const NodeId composed =
            substitute(to, from, std::array{root}, [&](Graph&, const Node& node, NodeId rebuilt) {
                return node.op == Op::input ? stands_for[std::size_t(node.index)] : rebuilt;
            })[0];
        Random random(seed);
        const Bindings<double> bindings = test_bindings();
        for (int k = 0; k < 10; ++k) {
            const Point p = random.point(1);
            Point q{};
            double largest = 1;
            for (std::size_t j = 0; j < 3; ++j) {
                Meaning meaning{p, bindings};
                q[j] = inner[j].value(meaning);
                largest = std::max(largest, meaning.largest);
            }
            Meaning meaning{q, bindings};
            const double expected = outer.value(meaning);
            // Both round, one after the other.
            const double slack = 1e-10 * std::max(largest, meaning.largest);
            if (!(slack < 1e-3)) continue;
            EXPECT_NEAR(value_of(to, composed, p, bindings), expected, slack);
        }
    }
}

} // namespace
} // namespace isomotion::formula
