// Weights of elements in means over them: their terms of a field's sums. If the field asks for the
// least element, only that element counts.
//
// A field may leave out elements of its sums where their terms are 0. A mean with these terms as
// weights may leave out the same elements; a mean with other weights may not.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// The term that weighs the elements of the sums over the array below `field`: that of the first
// sum, or, among sums that differ from it by factors of the place alone or of the element alone,
// that of the sum with the fewest factors. So it is the weight of a ratio of sums, wherever the
// ratio stands. None without such a sum.
std::optional<NodeId> element_weight(const Graph& graph, NodeId field, int array);

// The key of the first `least` over the array below `field`, for fields without a sum to weigh by.
std::optional<NodeId> least_key(const Graph& graph, NodeId field, int array);

// Whether the mean depends only on elements that the field keeps. The terms of all sums over the
// array below `roots` must be terms of sums of the field times factors of the place alone or of the
// element alone. Operations that ask for the least element must use a key through which alone the
// field reads the place.
bool weigh_like_field(const Graph& graph, NodeId field, std::span<const NodeId> roots, int array);

} // namespace isomotion::formula
