// The shapes of POV-Ray that have sizes: their formulas, below 0 inside.
#pragma once

#include <optional>
#include <string>

#include "scene/reading/pov_solids.h"

namespace isomotion::scene {

// Reads what stands in the braces before any modifier, if the word is such a shape: a sphere's
// centre and radius. Sets the formula, and the shape of a sphere or a box.
bool read_pov_shape(PovCursor& at, PovValues& values, PovSolid& solid);

// The components of a blob and its threshold, up to its modifiers.
std::string read_pov_blob(PovCursor& at, PovValues& values, const PovMoves& moves);

// The value of surface.bounds, in our axes. A box may be given by any two opposite corners.
std::string pov_sphere_bounds(const PovValue& centre, const PovNumber& radius);
std::string pov_box_bounds(PovValue low, PovValue high);
std::string pov_ball_bounds(const PovBall& ball);

// Numbers for TOML: plain ones as they are, others as texts.
std::string pov_value_text(const PovNumber& n);
std::string pov_vector_text(const PovValue& v);

} // namespace isomotion::scene
