// Where intervals can't tell that an expression is continuous, or its slope: its decoration, as an
// expression of the same graph, so that it is the same on every back end.
//
// A decoration is 0 over a box where what it says holds, and the entire line where it may not. That
// is how it is carried along: the entire line added to anything, or multiplied by what is not 0, is
// the entire line.
#pragma once

#include "formula/graph/graph.h"

namespace isomotion::formula {

// Whether the operation's values may lack a bound where those of its arguments have both: next to
// its poles, where it has no value, and where it is cut off at saturation.
bool may_be_unbounded(Op op);

// 0 where a base or an exponent is above 0: at 0^0 powers jump from 1 to 0, or to a pole.
NodeId unless_0_to_the_0(Graph& graph, NodeId base, NodeId exponent);

// Decoration of one operation, over a box where its arguments are continuous: the entire line where
// it may jump from one value to another, lack a value or be cut off.
NodeId unless_continuous(Graph& graph, NodeId operation);

// Decoration of all operations below `root`: 0 over boxes where the root has a value everywhere, is
// continuous and nowhere cut off ("dac" of IEEE 1788).
NodeId jumps(Graph& graph, NodeId root);

// ... over boxes without points where the root has no value: logarithms and real powers of negative
// numbers, 0/0. To be added to values and slopes, for what has bounds itself hides it: the
// enclosure of sin(log(x)) is [-1, 1] where x < 0.
NodeId gaps(Graph& graph, NodeId root);
NodeId with_gaps(Graph& graph, NodeId root);

// ... over boxes without a kink of min, max, select and least. Slopes over a box hold across these,
// but slopes of those slopes don't. Nothing need be added for jumps, where slopes of slopes are the
// entire line as slopes are, nor at the ends of sqrt, asin and acos, where they are quotients 0/0.
NodeId kinks(Graph& graph, NodeId root);

// Above 0 over boxes where the root has no value anywhere, as far as arithmetic tells; at least 0
// over all others. Sums of gaps() count as what they say.
NodeId without_value(Graph& graph, NodeId root);

// Above 0 over boxes where some operation has no value anywhere, whatever the root makes of that:
// all of such a box is within gaps(), so that no root is there. min(log(x), 3) has 3 where x < 0,
// and no surface.
NodeId within_gaps(Graph& graph, NodeId root);

} // namespace isomotion::formula
