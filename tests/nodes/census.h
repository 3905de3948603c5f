// Singular points of surfaces as scenes name them.
#pragma once

#include <string>
#include <vector>

#include "nodes/singular_points.h"
#include "scene/reading/load.h"

namespace isomotion {

// `surface` is what stands under [surface] in a scene: use = "cayley". Parameters are taken in
// double precision: rounded to float, some surfaces lose their nodes. The seed is $ISOMOTION_SEED,
// else 1.
Census census_of(const std::string& surface, const std::vector<scene::Override>& settings = {});

std::uint64_t census_seed();

// "31 nodes (1 x 0.372, ...), 2 degenerate (rank 1 at (1, 0, 1), ...), 8192 starts": counts and
// radii.
std::string describe(const Census& census);

} // namespace isomotion
