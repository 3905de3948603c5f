#include "formula/graph/in_range.h"

#include <algorithm>
#include <array>

#include "formula/graph/log_sums.h"
#include "formula/graph/power_sums.h"
#include "formula/graph/substitute.h"

namespace isomotion::formula {
namespace {

constexpr int first_largest = 1 << 16; // of the inputs that stand for m

} // namespace

InRange::InRange(Graph& graph, NodeId root, Purpose purpose)
    : graph_(graph)
    , root_(root) {
    const auto taken_from = [&](Graph& to, Term largest, const auto& value) {
        const Term m{&to, to.input(first_largest + int(largest_.size()))};
        // Those of sums within this one are known.
        largest_.push_back(complete(std::array{largest.node}).front());
        return value(m).node;
    };
    const auto replacement = [&](Graph& to, const Node& node, NodeId rebuilt) {
        const Node now = to[rebuilt]; // a copy: the graph grows
        // The input that stands for m belongs to no element.
        if (now.op != node.op || now.arrays != 0) return rebuilt;
        const Term first{&to, now.children[0]}, second{&to, now.children[1]};
        if (now.op == Op::log && purpose == Purpose::numbers) {
            const LogOfSum sum(first);
            if (sum.has_largest())
                return taken_from(to, sum.largest(), [&](Term m) { return sum.value(m); });
        } else if (now.op == Op::power) {
            const PowerOfSum sum(first, second);
            if (sum.has_largest())
                return taken_from(to, sum.largest(purpose),
                                  [&](Term m) { return sum.value(m, purpose); });
        }
        return rebuilt;
    };
    // Bounds of what lists leave out of a sum know it by its node.
    const NodeId replaced = purpose == Purpose::numbers
                                ? substitute(graph, graph, std::array{root}, replacement).front()
                                : substitute_outside_sums(graph, root, replacement);
    if (!largest_.empty()) root_ = replaced;
}

std::vector<NodeId> InRange::complete(std::span<const NodeId> roots) const {
    if (largest_.empty()) return {roots.begin(), roots.end()};
    const auto replacement = [this](Graph&, const Node& node, NodeId rebuilt) {
        const bool is_largest = node.op == Op::input && node.index >= first_largest;
        return is_largest ? largest_[std::size_t(node.index - first_largest)] : rebuilt;
    };
    return substitute(graph_, graph_, roots, replacement);
}

NodeId bounds_in_range(Graph& graph, NodeId root) {
    const InRange in_range(graph, root, Purpose::bounds);
    return in_range.complete(std::array{in_range.root()}).front();
}

} // namespace isomotion::formula
