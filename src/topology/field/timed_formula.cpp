#include "topology/field/timed_formula.h"

#include <algorithm>
#include <bit>

#include "formula/graph/substitute.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::Interval;
using formula::Node;
using formula::NodeId;
using formula::Op;

// Largest parts below the root that no point is needed for, if they are worth a place of their own:
// those of no array, and those of one element.
std::vector<NodeId> timed_parts(const Graph& graph, NodeId root) {
    const std::vector<NodeId> below = formula::nodes_below(graph, std::array{root});
    std::vector<bool> is_timed(graph.size(), false), is_largest(graph.size(), false);
    for (const NodeId id : below) {
        const Node& node = graph[id];
        bool timed = node.op == Op::input
                         ? node.index == clock_input
                         : !formula::is_over_elements(node.op) && std::popcount(node.arrays) <= 1;
        for (std::size_t k = 0; k < node.arity; ++k) timed = timed && is_timed[node.children[k]];
        is_timed[id] = timed;
    }
    is_largest[root] = is_timed[root];
    for (const NodeId id : below) {
        if (is_timed[id]) continue;
        for (std::size_t k = 0; k < graph[id].arity; ++k) {
            const NodeId child = graph[id].children[k];
            is_largest[child] = is_largest[child] || is_timed[child];
        }
    }
    std::vector<NodeId> parts;
    for (const NodeId id : below) {
        if (is_largest[id] && (graph[id].arity > 0 || graph[id].op == Op::input))
            parts.push_back(id);
    }
    return parts;
}

} // namespace

TimedFormula::Part TimedFormula::part(const Motion& motion, NodeId root) {
    Part part;
    Graph graph;
    const NodeId alone = formula::substitute(
        graph, motion.graph, std::array{root}, [&](Graph& to, const Node& node, NodeId rebuilt) {
            if (node.op == Op::input) return to.input(0);
            if (node.op != Op::element) return rebuilt;
            part.array = node.index;
            const auto at = std::ranges::find(part.fields, node.second);
            const auto which = int(at - part.fields.begin());
            if (at == part.fields.end()) part.fields.push_back(node.second);
            return to.input(1 + which);
        })[0];
    part.program = formula::schedule(graph, std::array{alone});
    return part;
}

TimedFormula::TimedFormula(const Motion& motion)
    : clock_(motion.clock)
    , shape_(motion.shape)
    , resting_(formula::convert<Interval>(motion.bindings)) {
    const Graph& from = motion.graph;
    std::vector<int> fields; // of each array
    for (const auto& array : resting_.arrays) fields.push_back(int(array.fields.size()));
    const std::vector<NodeId> parts = timed_parts(from, motion.field);
    std::vector<std::pair<Node, NodeId>> timed;
    Graph& to = formula_.graph;
    for (const NodeId id : parts) {
        Part made = part(motion, id);
        if (made.array < 0) {
            timed.emplace_back(from[id],
                               to.parameter(int(resting_.parameters.size() + parameters_.size())));
            parameters_.push_back(std::move(made));
        } else {
            timed.emplace_back(from[id], to.element(made.array, fields[std::size_t(made.array)]++));
            columns_.push_back(std::move(made));
        }
    }
    formula_.root = formula::substitute(
        to, from, std::array{motion.field}, [&](Graph&, const Node& node, NodeId rebuilt) {
            const auto at = std::ranges::find(timed, node, &std::pair<Node, NodeId>::first);
            return at == timed.end() ? rebuilt : at->second;
        })[0];
    formula_.bindings = bindings(mid(clock_));

    std::vector<NodeId> walls(motion.low.begin(), motion.low.end());
    walls.insert(walls.end(), motion.high.begin(), motion.high.end());
    if (shape_ == scene::Bounds::Shape::sphere) {
        walls.insert(walls.end(), motion.centre.begin(), motion.centre.end());
        walls.push_back(motion.radius);
    }
    for (const NodeId wall : walls) bounds_.push_back(part(motion, wall));
}

formula::Bindings<Interval> TimedFormula::bindings(Interval time) const {
    formula::Bindings<Interval> all = resting_;
    for (const Part& part : parameters_) {
        Interval value;
        formula::Evaluator<Interval>(part.program).point(resting_, {&time, 1}, {&value, 1});
        all.parameters.push_back(value);
    }
    for (const Part& part : columns_) {
        const auto& from = resting_.arrays[std::size_t(part.array)];
        const std::vector<Interval> times(std::size_t(from.count), time);
        std::vector<std::span<const Interval>> inputs{times};
        for (const int field : part.fields) inputs.emplace_back(from.fields[std::size_t(field)]);
        std::vector<Interval> column(times.size());
        const std::span<Interval> output = column;
        formula::Evaluator<Interval>(part.program).points(resting_, inputs, {&output, 1});
        all.arrays[std::size_t(part.array)].fields.push_back(std::move(column));
    }
    return all;
}

EnclosedBounds TimedFormula::bounds(Interval time) const {
    std::vector<Interval> walls;
    for (const Part& part : bounds_) {
        Interval& value = walls.emplace_back();
        formula::Evaluator<Interval>(part.program).point(resting_, {&time, 1}, {&value, 1});
    }
    EnclosedBounds bounds{.shape = shape_};
    for (std::size_t i = 0; i < 3; ++i) {
        bounds.low[i] = walls[i];
        bounds.high[i] = walls[3 + i];
        if (shape_ == scene::Bounds::Shape::sphere) bounds.centre[i] = walls[6 + i];
    }
    if (shape_ == scene::Bounds::Shape::sphere) bounds.radius = walls[9];
    return bounds;
}

scene::BoundsAt TimedFormula::bounds(double time) const {
    const EnclosedBounds exact = bounds(Interval(time));
    scene::BoundsAt rounded;
    rounded.shape = shape_;
    for (std::size_t i = 0; i < 3; ++i) {
        rounded.min[int(i)] = mid(exact.low[i]);
        rounded.max[int(i)] = mid(exact.high[i]);
        rounded.centre[int(i)] = mid(exact.centre[i]);
    }
    rounded.radius = mid(exact.radius);
    if (shape_ == scene::Bounds::Shape::box) {
        rounded.centre = 0.5 * (rounded.min + rounded.max);
        rounded.radius = 0.5 * glm::distance(rounded.min, rounded.max);
    }
    return rounded;
}

} // namespace isomotion::topology
