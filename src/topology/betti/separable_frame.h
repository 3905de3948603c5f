// Proves Betti numbers of a frame whose formula is a sum of functions of x, of y and of z, in a
// box.
//
// Between the points along an axis where its function turns, that function is monotone. So the axes
// can be stretched until all three functions are linear between these points; then F is linear in
// each box of the grid of these points, and the Betti numbers are those of the signs at its
// vertices. The surface may reach the bounds. The proof is in docs/topology-frames.md.
#pragma once

#include "topology/betti/certified_frame.h"

namespace isomotion::topology {

// Without Betti numbers if the formula is no such sum, or has no such grid with certain signs.
CertifiedFrame certify_separable(const SpaceFormula& formula, const scene::BoundsAt& bounds);

} // namespace isomotion::topology
