#include "formula/graph/own_functions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "formula/graph/operations.h"
#include "formula/graph/substitute.h"

namespace isomotion::formula {

void OwnFunctions::add(std::string_view name, OwnFunction function) {
    functions_.insert_or_assign(std::string(name), std::move(function));
}

const OwnFunction* OwnFunctions::find(std::string_view name) const {
    const auto found = functions_.find(name);
    return found == functions_.end() ? nullptr : &found->second;
}

std::vector<std::string> OwnFunctions::names() const {
    std::vector<std::string> names;
    for (const auto& [name, function] : functions_) names.push_back(name);
    return names;
}

NodeId OwnFunctions::call(Graph& to, const OwnFunction& function,
                          std::span<const NodeId> arguments) const {
    const bool is_within_body = &to == &bodies_;
    const auto in_its_place = [&](Graph& graph, const Node& node, NodeId rebuilt) {
        if (node.op == Op::at) {
            const auto& of = graph[rebuilt].children;
            const std::array<NodeId, 3> point{of[0], of[1], of[2]};
            if (node.index < first_outside)
                return at_point(graph, arguments[std::size_t(node.index - first_argument)], point);
            return is_within_body ? rebuilt
                                  : at_point(graph, NodeId(node.index - first_outside), point);
        }
        if (node.op != Op::input || node.index < first_argument) return rebuilt;
        if (node.index < first_outside) return arguments[std::size_t(node.index - first_argument)];
        return is_within_body ? rebuilt : NodeId(node.index - first_outside);
    };
    return substitute(to, bodies_, std::array{function.body}, in_its_place).front();
}

NodeId at_point(Graph& graph, NodeId expression, const std::array<NodeId, 3>& point) {
    const auto in_its_place = [&](Graph& to, const Node& node, NodeId rebuilt) {
        if (node.op != Op::input) return rebuilt;
        if (node.index < int(point.size())) return point[std::size_t(node.index)];
        return node.index < OwnFunctions::first_argument ? rebuilt : to.at(node.index, point);
    };
    return substitute(graph, graph, std::array{expression}, in_its_place).front();
}

std::optional<int> OwnFunctions::array_of(const OwnFunction& function,
                                          std::span<const int> arrays) const {
    for (const NodeId id : nodes_below(bodies_, std::array{function.body})) {
        const Node& node = bodies_[id];
        if (is_over_elements(node.op) && std::ranges::count(arrays, node.index) > 0)
            return node.index;
    }
    return std::nullopt;
}

bool has_undefined_constant(const Graph& graph, std::size_t first) {
    for (NodeId id = NodeId(first); id < graph.size(); ++id) {
        const Node& node = graph[id];
        const bool has_value =
            node.op != Op::constant || std::abs(node.value) < Operations<double>::saturation();
        const bool divides_by_0 = node.op == Op::divide && graph.is_constant(node.children[1], 0);
        if (!has_value || divides_by_0) return true;
    }
    return false;
}

} // namespace isomotion::formula
