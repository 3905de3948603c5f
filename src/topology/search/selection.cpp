#include "topology/search/selection.h"

#include <algorithm>

#include "formula/graph/derivative.h"
#include "formula/graph/substitute.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::Interval;
using formula::Node;
using formula::NodeId;
using formula::Op;

formula::Program height_program(const KinkTree& tree, NodeId root, std::size_t kinks) {
    if (kinks == 0) return {};
    Graph g;
    g.fold_exactly();
    root = formula::substitute(g, tree.formula().graph, std::array{root},
                               [](Graph&, const Node&, NodeId rebuilt) { return rebuilt; })[0];
    std::vector<NodeId> heights;
    for (std::size_t k = 0; k < kinks; ++k) {
        std::vector<NodeId> direction(std::size_t(first_height_input) + kinks, g.constant(0));
        direction[std::size_t(first_height_input) + k] = g.constant(1);
        heights.push_back(
            formula::differentiate_inputs(g, root, direction, formula::Slopes::generalized));
    }
    return formula::schedule(g, heights);
}

} // namespace

// A formula of its own graph; inputs of heights are 0, and intervals of parameters are points.
Motion with_field(const Motion& motion, const BoundFormula& formula, NodeId root) {
    Motion made = motion;
    made.graph = Graph{};
    made.graph.fold_exactly();
    const auto copy = [&](const Graph& of, NodeId node) {
        return formula::substitute(
            made.graph, of, std::array{node}, [](Graph& to, const Node& leaf, NodeId rebuilt) {
                const bool is_height = leaf.op == Op::input && leaf.index >= first_height_input;
                return is_height ? to.constant(0) : rebuilt;
            })[0];
    };
    made.field = copy(formula.graph, root);
    for (std::size_t k = 0; k < 3; ++k) {
        made.low[k] = copy(motion.graph, motion.low[k]);
        made.high[k] = copy(motion.graph, motion.high[k]);
        if (motion.shape == scene::Bounds::Shape::sphere)
            made.centre[k] = copy(motion.graph, motion.centre[k]);
    }
    if (motion.shape == scene::Bounds::Shape::sphere)
        made.radius = copy(motion.graph, motion.radius);
    made.bindings.parameters.clear();
    for (const Interval& value : formula.bindings.parameters)
        made.bindings.parameters.push_back(mid(value));
    return made;
}

Selection::Selection(const Motion& motion, const Stratum& stratum, const KinkTree& tree,
                     const KinkTree::Branch& branch)
    : kinks_(KinkTree::kinks(branch).begin(), KinkTree::kinks(branch).end())
    , multipliers_(KinkTree::ranges(branch).size())
    , field_(with_field(motion, tree.formula(), KinkTree::root(branch)), stratum, {},
             KinkTree::ranges(branch))
    , bindings_(tree.formula().bindings)
    , heights_(height_program(tree, KinkTree::root(branch), kinks_.size())) {}

std::vector<Interval> Selection::heights(const Box& box, const SpaceBox& place) const {
    std::vector<Interval> inputs(std::size_t(first_height_input) + kinks_.size(), Interval(0));
    std::ranges::copy(place, inputs.begin());
    inputs[clock_input] = box[field_.clock()];
    std::ranges::copy(multipliers(box), inputs.begin() + first_multiplier_input);
    std::vector<Interval> values(kinks_.size());
    if (!values.empty()) formula::Evaluator<Interval>(heights_).point(bindings_, inputs, values);
    return values;
}

} // namespace isomotion::topology
