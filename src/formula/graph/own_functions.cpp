#include "formula/graph/own_functions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "formula/graph/limits.h"
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

namespace {

void check_work(std::size_t work, const Graph& graph) {
    if (work > limits::calls_work) throw CallError("the formula calls large functions too often");
    if (graph.size() > limits::formula_nodes)
        throw CallError("the formula becomes too large: functions repeat what they are given");
}

} // namespace

NodeId OwnFunctions::call(Graph& to, const OwnFunction& function, std::span<const NodeId> arguments,
                          std::size_t& work) const {
    const bool is_within_body = &to == &bodies_;
    work += std::size_t(function.body) + 1;
    check_work(work, to);
    const auto in_its_place = [&](Graph& graph, const Node& node, NodeId rebuilt) {
        if (node.op == Op::at) {
            const auto& of = graph[rebuilt].children;
            const std::array<NodeId, 3> point{of[0], of[1], of[2]};
            if (node.index < first_outside) {
                const NodeId argument = arguments[std::size_t(node.index - first_argument)];
                return at_point(graph, argument, point, work);
            }
            return is_within_body
                       ? rebuilt
                       : at_point(graph, NodeId(node.index - first_outside), point, work);
        }
        if (node.op != Op::input || node.index < first_argument) return rebuilt;
        if (node.index < first_outside) return arguments[std::size_t(node.index - first_argument)];
        return is_within_body ? rebuilt : NodeId(node.index - first_outside);
    };
    return substitute(to, bodies_, std::array{function.body}, in_its_place).front();
}

bool OwnFunctions::has_place(const OwnFunction& function) const {
    return std::ranges::any_of(nodes_below(bodies_, std::array{function.body}), [&](NodeId id) {
        const Node& node = bodies_[id];
        return node.op == Op::at || (node.op == Op::input && node.index < first_argument);
    });
}

NodeId at_point(Graph& graph, NodeId expression, const std::array<NodeId, 3>& point,
                std::size_t& work) {
    work += std::size_t(expression) + 1;
    check_work(work, graph);
    std::uint32_t arrays = 0; // whose elements the point depends on
    for (const NodeId coordinate : point) arrays |= graph[coordinate].arrays;
    const auto in_its_place = [&](Graph& to, const Node& node, NodeId rebuilt) {
        // The loop's own element would be taken for that of the loop outside.
        if (is_over_elements(node.op) && (arrays >> node.index & 1) != 0)
            throw CallError("a part that goes through an array is moved by the array's fields");
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
