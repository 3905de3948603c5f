// Conditions, and choices by them. A condition is a value, 1 where it holds and 0 elsewhere.
#pragma once

#include <span>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// Whether the node is a choice that a formula makes. Other selections are slopes, or cut off what
// is large, and jump nowhere.
bool is_choice(const Node& node);

NodeId is_less(Graph& graph, NodeId a, NodeId b);    // a < b
NodeId is_at_most(Graph& graph, NodeId a, NodeId b); // a <= b

// a where the condition holds, b elsewhere. Any number but 0 holds. What is not chosen need have no
// value. Choices of the smaller or the larger of two, and of a size, become min, max and abs.
NodeId choose(Graph& graph, NodeId condition, NodeId a, NodeId b);

// Conditions that hold where each of these does, or any; one alone stays what it is. Later ones are
// looked at where those before leave it open.
NodeId are_all(Graph& graph, std::span<const NodeId> conditions);
NodeId is_any(Graph& graph, std::span<const NodeId> conditions);

// Whether it is a condition, as far as its form shows.
bool is_condition(const Graph& graph, NodeId id);

// An expression below 0 where a condition holds and above 0 where it does not, so 0 at the boundary
// of the solid that it describes. `and` makes an intersection, `or` a union.
NodeId solid_of(Graph& graph, NodeId condition);

} // namespace isomotion::formula
