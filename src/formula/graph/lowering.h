// Lowers structured primitives (chebyshev) to sums and products.
//
// Interval bounds need the primitive: T_n maps [-1,1] to [-1,1] exactly. Evaluation in numbers
// needs few products: (T_n, U_{n-1}) behaves like (cos n theta, sin n theta / sin theta), so
// doubling the angle takes log2(n) steps and gives the value and the derivative n U_{n-1} together.
// Measured in float32 at 4e7 points of [-1,1], the largest error for n = 14 / 50 is 2.1e-6 /
// 2.5e-5, compared with 3.9e-6 / 2.4e-5 for the three-term recurrence and 4.4e-6 / 1.6e-5 for cos(n
// acos x).
#pragma once

#include <span>

#include "formula/graph/graph.h"
#include "formula/graph/program.h"

namespace isomotion::formula {

// The size of the argument beyond which T_n keeps its value, for n above highest_whole_degree:
// beyond it the float32 value or the first derivatives would exceed saturation. |T_n| grows like
// cosh(n acosh |x|), and the k-th derivative is at most n^2k times larger: T_50(6) is 10^53.
double chebyshev_reach(int n);
inline constexpr int highest_whole_degree = 24;

// Nodes equal to `roots` that have no chebyshev nodes below them.
std::vector<NodeId> lower(Graph& graph, std::span<const NodeId> roots);

// The same with the fewest products for values alone: T_2n = 2 T_n^2 - 1 and T_2n+1 = 2 T_n T_n+1 -
// x. Bounds on what is left out of T_n grow no faster by these, and T_14 takes 5 products, not 10.
NodeId lower_to_fewest_products(Graph& graph, NodeId root);

// Lowers and schedules one expression.
Program schedule_lowered(Graph& graph, NodeId root);

} // namespace isomotion::formula
