// Chebyshev polynomials that are written by angles, as primitives.
//
// cos(n acos a) is T_n(a), and so is cosh(n acosh a) for a >= 1; acosh a may be written as
// log(a + sqrt(a^2 - 1)). One counts inside [-1, 1], the other outside. If each is 1 elsewhere,
// their product is T_n everywhere. Values on paper are the same. But intervals of the slope of acos
// and of that root have no bound at 1, where the polynomial's slope is n^2.
#pragma once

#include <functional>
#include <optional>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// An expression whose intervals hold all that `root` may be on paper, and what cosh is cut off to.
// The graph folds exactly. Returns `root` itself where no such thing is found, and for formulas
// that go through the elements of arrays, whose sums keep their numbers.
NodeId with_chebyshev(Graph& graph, NodeId root);

// The same as polynomials: what is cut off is replaced by what it is before; or, if `told`, by that
// up to its end (min and max), beyond which the expression may be anything.
NodeId with_whole_chebyshev(Graph& graph, NodeId root, bool told);

// The same on paper, where nothing is cut off, also for formulas that go through elements. `number`
// is the value of a parameter that has only one: n may be such a parameter.
NodeId chebyshev_on_paper(Graph& graph, NodeId root,
                          const std::function<std::optional<double>(int parameter)>& number);

} // namespace isomotion::formula
