// The range of a paint's number on what a scene shows.
#pragma once

#include <stdexcept>

#include "scene/scene.h"

namespace isomotion::scene {

// Why no range is found.
struct NoRange : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct ShownRange {
    Range range;
    bool met = true; // some ray met the surface
};

// The least and the greatest finite number where the rays of small pictures of some frames, the
// first and the last among them, first meet the surface, in double on this processor. How many rays
// and frames follows from what the formula costs, so that it mostly takes less than a second. It is
// the scene's alone, whatever frames are asked for and however large. What is smaller than the
// rays' samples may be missed, so some numbers may lie beyond. Where all are the same, that is in
// the middle of the range; where nothing is met, it is 0 to 1. The paint names no evaluations.
//
// Throws NoRange where even few rays take too long, and where the surface is met but no number of
// it is finite.
ShownRange shown_range(const Scene& scene, const formula::Paint& paint);

} // namespace isomotion::scene
