// The range of a paint's number over the part of the surface that a scene shows.
#pragma once

#include <stdexcept>

#include "scene/scene.h"

namespace isomotion::probe {

// Thrown if no range is found; says why.
struct NoRange : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct ShownRange {
    scene::Range range;
    bool met = true; // some ray met the surface
};

// The least and the greatest finite number at the first hits of rays. The rays belong to small
// pictures of some frames, including the first and the last, and are traced in double on the CPU.
// The number of rays and frames depends on the cost of the formula, so that the search mostly takes
// less than a second. The result depends only on the scene, not on the frames asked for or their
// size. Details finer than the rays' spacing may be missed, so some numbers may lie beyond the
// range. If all numbers are equal, they are in the middle of the range; if nothing is hit, it is 0
// to 1. The paint must not name evaluations.
//
// Throws NoRange if even few rays take too long, or if the surface is hit but no number on it is
// finite.
ShownRange shown_range(const scene::OneSurface& one, const formula::Paint& paint);

} // namespace isomotion::probe
