// Computes the Morse index of a critical point.
#pragma once

#include <optional>

#include "topology/search/krawczyk.h"

namespace isomotion::topology {

// The number of negative eigenvalues of each symmetric matrix in `hessian` (its first n rows and
// columns). Empty if it is not the same for all, or if one eigenvalue may be 0.
//
// By Sylvester's law of inertia V^T H V has as many as H, for regular V. With the eigenvectors of
// the middle of H in V, that product is nearly diagonal, and Gershgorin's discs give the signs. If
// none of them holds 0, the product is regular, and so is V.
std::optional<int> negative_eigenvalues(const IntervalMatrix& hessian, int n);

} // namespace isomotion::topology
