// Blends in other forms: the same values, without the kinks of what they are made of.
#include "topology/field/smooth_joints.h"

#include <random>

#include "formula/evaluate/evaluate.h"
#include "formula/graph/substitute.h"
#include "topology/moving.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::NodeId;
using formula::Op;

// Formulas name s, and may name k.
Motion first_motion_of(const std::string& formula) {
    const bool has_k = formula.find('k') != std::string::npos;
    const Moving moving{formula, "{ box = [[-2.1, -2, -1.9], [1.8, 2, 2.2]] }",
                        std::string("s = \"0.1 + t\"\n") + (has_k ? "k = 0.3" : "")};
    return motions(moving.scene(), Side::negative, {0, 1}).pieces.front();
}

void expect_equal(const Graph& graph, NodeId a, NodeId b, const Motion& motion) {
    constexpr unsigned seed = 17;
    SCOPED_TRACE(fmt::format("seed {}", seed));
    std::mt19937 random(seed);
    formula::Evaluator<double> both(formula::schedule(graph, std::array{a, b}));
    for (int k = 0; k < 200; ++k) {
        std::array<double, clock_input + 1> inputs{};
        for (double& input : inputs) input = 4 * double(random()) / 0x1p32 - 2;
        std::array<double, 2> values{};
        both.point(motion.bindings, inputs, values);
        EXPECT_NEAR(values[0], values[1], 1e-12 * (1 + std::abs(values[0])));
    }
}

TEST(SmoothJoints, BlendsAreTheSameInPieces) {
    for (const char* formula :
         {"smoothmin(x^2 + y^2 + z^2 - 1, z + s, 0.2)", "-smoothmin(-x - s, y^2 - z, k)",
          "smoothmin(smoothmin(x, y - s, 0.4), z, 1 + s^2) + x*y",
          "z - smoothmin(sqrt(x^2 + y^2) - s, 0.5, 2*k)^2"}) {
        SCOPED_TRACE(formula);
        const Motion motion = first_motion_of(formula);
        Graph graph = motion.graph;
        std::vector<Narrower> narrower;
        const NodeId made = with_blends_in_pieces(graph, motion, narrower);
        EXPECT_NE(made, motion.field);
        expect_equal(graph, made, motion.field, motion);
        EXPECT_EQ(narrower.size() % 2, 0u);
        for (const Narrower& one : narrower) expect_equal(graph, one.than, one.is, motion);
    }
}

// Where k may be 0, smoothmin is a minimum.
TEST(SmoothJoints, BlendsThatMayEndStay) {
    for (const char* formula : {"smoothmin(x, y - s, 0)", "smoothmin(x, y, s - 0.5)",
                                "smoothmin(x, y - s, 1 + z)", "min(min(x - 1, y), z - s)"}) {
        const Motion motion = first_motion_of(formula);
        Graph graph = motion.graph;
        std::vector<Narrower> narrower;
        EXPECT_EQ(with_blends_in_pieces(graph, motion, narrower), motion.field) << formula;
        EXPECT_TRUE(narrower.empty());
    }
}

// Without the difference of the first min().
std::optional<NodeId> without_height(Graph& graph, const Motion& motion) {
    graph.fold_exactly();
    for (const NodeId id : formula::nodes_below(graph, std::array{motion.field})) {
        if (graph[id].op != Op::min) continue;
        const auto values = formula::convert<formula::Interval>(motion.bindings);
        return without_even_height(graph, motion.field,
                                   *difference(graph, formula::Node(graph[id])), values.parameters);
    }
    return std::nullopt;
}

TEST(SmoothJoints, EvenPowersOfAHeightHaveNoKink) {
    const std::string names = "a = x^2 + s; b = y*z; ";
    for (const char* formula :
         {"min(a, b) - (0.4 - abs(a - b))^2/1.6",
          "min(b, a) - (0.4 - abs(a - b))^2/1.6 + max(a, b)*0", "2*min(a, b) + abs(a - b) - x",
          "(min(a, b) - (k - abs(a - b))^2/(4*k))*(1 + x^2)",
          "(min(a, b) + max(a, b))^2 + abs(a - b)^4 - x"}) {
        SCOPED_TRACE(formula);
        const Motion motion = first_motion_of(names + formula);
        Graph graph = motion.graph;
        const auto smooth = without_height(graph, motion);
        ASSERT_TRUE(smooth);
        expect_equal(graph, *smooth, motion.field, motion);
        for (const NodeId id : formula::nodes_below(graph, std::array{*smooth}))
            EXPECT_FALSE(difference(graph, formula::Node(graph[id])));
    }
    for (const char* formula :
         {"min(a, b) - (0.4 - abs(a - b))^2/1.7", "min(a, b) - max(0.4 - abs(a - b), 0)^2/1.6",
          "min(a, b) - (0.4 - abs(a - b))^3/0.96", "min(a, b) - x", "sin(min(a, b)) + abs(a - b)",
          "1/(2 + min(a, b) + 0.5*abs(a - b))"}) {
        const Motion motion = first_motion_of(names + formula);
        Graph graph = motion.graph;
        EXPECT_FALSE(without_height(graph, motion)) << formula;
    }
}

} // namespace
} // namespace isomotion::topology
