#include "topology/field/idle_parts.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "formula/graph/substitute.h"
#include "formula/interval/prune.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::Interval;
using formula::Judged;
using formula::Node;
using formula::NodeId;
using formula::Op;

using Inputs = std::array<Interval, clock_input + 2>;

std::vector<Interval> values(const Motion& motion, std::span<const NodeId> roots,
                             const Inputs& inputs) {
    const formula::Program program = formula::schedule(motion.graph, roots);
    std::vector<Interval> values(roots.size());
    formula::Evaluator<Interval>(program).point(formula::convert<Interval>(motion.bindings), inputs,
                                                values);
    return values;
}

// All places of the bounds and all times of the clock; none where the bounds may be empty.
std::optional<Inputs> everywhere(const Motion& motion) {
    Inputs inputs;
    inputs.fill(Interval::entire());
    inputs[clock_input] = motion.clock;
    const std::vector<Interval> low = values(motion, motion.low, inputs);
    const std::vector<Interval> high = values(motion, motion.high, inputs);
    for (std::size_t k = 0; k < 3; ++k) {
        if (!(low[k].lo <= high[k].hi)) return std::nullopt;
        inputs[k] = {low[k].lo, high[k].hi};
    }
    return inputs;
}

// What the expression is without the clamp around it, if that does nothing.
std::optional<NodeId> without_clamp(const Motion& motion, NodeId id, const Inputs& inputs) {
    const Node& node = motion.graph[id];
    if ((node.op != Op::min && node.op != Op::max) || node.arrays != 0) return std::nullopt;
    const std::array operands{node.children[0], node.children[1]};
    const std::vector<Interval> of = values(motion, operands, inputs);
    const std::size_t less = of[0].hi <= of[1].lo ? 0 : 1;
    if (of[less].hi > of[1 - less].lo) return std::nullopt;
    return operands[node.op == Op::min ? less : 1 - less];
}

// Whether intervals over parts of all places and times, halved as far as needed, show that an
// expression is never 0.
bool is_never_0(const Motion& motion, NodeId id, const Inputs& everywhere) {
    constexpr int most_asked = 512;
    const formula::Program program = formula::schedule(motion.graph, std::array{id});
    const auto bindings = formula::convert<Interval>(motion.bindings);
    formula::Evaluator<Interval> evaluator(program);
    int asked = 0;
    const formula::Sides places_and_clock{0, clock_input + 1};
    return formula::prune(everywhere, everywhere, places_and_clock, [&](const Inputs& inputs) {
        Interval value;
        evaluator.point(bindings, inputs, {&value, 1});
        ++asked;
        if (!contains(value, 0.0)) return Judged::settled;
        return asked > most_asked ? Judged::refused : Judged::open;
    });
}

// Drops what is added to the field for quotients that are nowhere 0/0.
void drop_idle_gaps(Motion& motion, const Inputs& inputs) {
    Graph& g = motion.graph;
    // 0 < |a| ? 0 : ...
    const auto is_gap = [&](const Graph& graph, const Node& node) {
        const auto is_0 = [&](std::size_t k) { return graph.is_constant(node.children[k], 0); };
        return node.op == Op::select && node.arrays == 0 && is_0(0) && is_0(2) &&
               graph[node.children[1]].op == Op::abs;
    };
    std::vector<Node> idle;
    for (const NodeId id : formula::nodes_below(g, std::array{motion.field})) {
        const Node node = g[id];
        if (is_gap(g, node) && is_never_0(motion, g[node.children[1]].children[0], inputs))
            idle.push_back(node);
    }
    if (idle.empty()) return;
    motion.field = formula::substitute(
        g, g, std::array{motion.field}, [&](Graph& to, const Node& node, NodeId rebuilt) {
            return std::ranges::find(idle, node) != idle.end() ? to.constant(0) : rebuilt;
        })[0];
}

} // namespace

void drop_idle_parts(Motion& motion) {
    Graph& g = motion.graph;
    const auto inputs = everywhere(motion);
    if (!inputs) return;
    drop_idle_gaps(motion, *inputs);
    const auto with_idle_clamp = [&]() -> std::optional<std::pair<NodeId, NodeId>> {
        for (const NodeId id : formula::nodes_below(g, std::array{motion.field})) {
            if (g[id].op != Op::chebyshev) continue;
            if (const auto of = without_clamp(motion, g[id].children[0], *inputs))
                return std::pair(id, *of);
        }
        return std::nullopt;
    };
    for (;;) {
        const auto found = with_idle_clamp();
        if (!found) return;
        const Node polynomial = g[found->first];
        const auto in_its_place = [&](Graph& to, const Node& node, NodeId rebuilt) {
            return node == polynomial ? to.chebyshev(node.index, found->second, node.second)
                                      : rebuilt;
        };
        motion.field = formula::substitute(g, g, std::array{motion.field}, in_its_place)[0];
    }
}

} // namespace isomotion::topology
