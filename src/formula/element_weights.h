// How elements weigh in means over them: by their terms of a field's sums. Where the field asks for
// the least element, that one alone counts.
//
// Where a field leaves out elements of its sums, as their terms are nothing there, so may a mean
// that weighs by these terms; a mean that weighs otherwise may not.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// The term of the sums over the array below `field` that weighs its elements: the first sum's, or
// of those that differ from it by factors of the place alone or of the element alone the one with
// the fewest factors. So it is the weight of a ratio of sums, wherever that stands. None without
// such a sum.
std::optional<NodeId> element_weight(const Graph& graph, NodeId field, int array);

// The key of the first `least` over the array below `field`, for those of which no sum tells more.
std::optional<NodeId> least_key(const Graph& graph, NodeId field, int array);

// Whether the terms of all sums over the array below `roots` are terms of sums of the field times
// further factors, each of the place alone or of the element alone; and whatever asks for the least
// element does so by a key that the field reads the place through, and through nothing else.
bool weigh_like_field(const Graph& graph, NodeId field, std::span<const NodeId> roots, int array);

} // namespace isomotion::formula
