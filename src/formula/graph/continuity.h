// Decorations: expressions that tell where intervals can't show that an expression, or its slope,
// is continuous. A decoration is an expression of the same graph, so it is the same on every back
// end.
//
// A decoration is 0 over a box where its claim holds, and the entire line where it may not hold. So
// arithmetic propagates it: the entire line added to anything, or multiplied by anything but 0, is
// the entire line.
#pragma once

#include "formula/graph/graph.h"

namespace isomotion::formula {

// Whether the operation's values may be unbounded although those of its arguments are bounded: next
// to its poles, where it has no value, and where it is cut off at saturation.
bool may_be_unbounded(Op op);

// 0 where a base or an exponent is above 0. At 0^0 powers jump from 1 to 0, or to a pole.
NodeId unless_0_to_the_0(Graph& graph, NodeId base, NodeId exponent);

// Decoration of one operation, over a box where its arguments are continuous. It is the entire line
// where the operation may jump from one value to another, lack a value or be cut off.
NodeId unless_continuous(Graph& graph, NodeId operation);

// Decoration of all operations below `root`: 0 over boxes where the root has a value everywhere, is
// continuous and is nowhere cut off ("dac" of IEEE 1788).
NodeId jumps(Graph& graph, NodeId root);

// Decoration of values: 0 over boxes without points where the root has no value (logarithms and
// real powers of negative numbers, 0/0). Add it to values and slopes, since a bounded operation
// hides such points: the enclosure of sin(log(x)) is [-1, 1] where x < 0.
NodeId gaps(Graph& graph, NodeId root);
NodeId with_gaps(Graph& graph, NodeId root);

// Decoration of kinks: 0 over boxes without a kink of min, max, select and least. Slopes over a box
// hold across kinks, but slopes of slopes don't. Jumps need no decoration here: slopes are the
// entire line there, and so are slopes of slopes. The ends of sqrt, asin and acos need none either,
// since slopes there are quotients 0/0.
NodeId kinks(Graph& graph, NodeId root);

// Above 0 over boxes where the root has no value anywhere, as far as arithmetic tells; at least 0
// over all other boxes. Sums of gaps() are interpreted as gaps.
NodeId without_value(Graph& graph, NodeId root);

// Above 0 over boxes where some operation has no value anywhere, whatever the root makes of that.
// Such a box is entirely within gaps(), so it holds no root. For example min(log(x), 3) is 3 where
// x < 0, but has no surface there.
NodeId within_gaps(Graph& graph, NodeId root);

// Above 0 over boxes where some divisor is 0 everywhere, whatever the root makes of that; at least
// 0 over all other boxes. The root may jump at each point of such a box, by jumps(), so it holds no
// root: z - exp(-x^2/s) has no surface where s = 0.
NodeId divided_by_0(Graph& graph, NodeId root);

} // namespace isomotion::formula
