// Logarithms of sums of exponentials, as of bodies that are blended by log(exp(-k*a) + exp(-k*b)).
#pragma once

#include "formula/graph/graph.h"

namespace isomotion::formula {

// An expression equal to the root on paper, whose exponentials below logarithms are at most 1:
// log(p*exp(u) + q*exp(v)) as m + log(p*exp(u - m) + q*exp(v - m)), where m is the larger of u and
// v. Exponentials alone are 0 below exp(-87) in float32 and cut off at exp(69), so F would be flat
// there, or infinite. For values: in intervals m would count several times.
NodeId with_small_exponents(Graph& graph, NodeId root);

// Whether there is a logarithm of exponentials that are summed over elements. Such a sum stays as it
// is, so it may come to 0 in floats, where its logarithm jumps from -87 to where it is cut off.
bool has_fading_logs(const Graph& graph, NodeId root);

} // namespace isomotion::formula
