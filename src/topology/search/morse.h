// The Morse index of a critical point.
#pragma once

#include <optional>

#include "topology/search/krawczyk.h"

namespace isomotion::topology {

// How many eigenvalues of each symmetric matrix in `hessian` (its first n rows and columns) are
// negative; empty if that is not the same for all, or one may be 0.
//
// By Sylvester's law of inertia V^T H V has as many as H, for regular V. With the eigenvectors of
// the middle of H in V, that product is nearly diagonal, and Gershgorin's discs tell; where none of
// them holds 0 it is regular, and so is V.
std::optional<int> negative_eigenvalues(const IntervalMatrix& hessian, int n);

} // namespace isomotion::topology
