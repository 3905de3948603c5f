// A hard case: a scene that breaks renderers, drawn and compared with certified truth.
//
// Each case has a bound on what a method may get wrong, a little above what it gets wrong now: a
// change that makes a method worse breaks it, and one that makes it better earns a tighter bound.
#pragma once

#include <array>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "accuracy/compare.h"
#include "render/drawing.h"

namespace isomotion::stability {

// A method that a case blinds may be wrong everywhere, but only by hits too soon: it misses no
// root.
inline constexpr double blind = 1e6;

// The most pixels in a million that the method may get wrong.
struct Bound {
    scene::Method method;
    double wrong_ppm = 0;
};

struct HardCase {
    std::string name;
    std::string scene;         // TOML
    std::vector<Bound> bounds; // of methods that are asked for
    // The same points by a formula that is easier to certify, as G for G^2; empty for `scene`.
    std::string truth = {};
    double by_default = 0; // of what a scene gets that names no method, as in Bound
    // Whether F passes 10^30 on the way to the surface, or is noise there: its size matters.
    bool is_cut_off = false;
    bool is_drawn_by_chance = false; // no row of the table
};

// What was drawn with a method and what of it is wrong. `crooked` counts the hits whose position or
// normal is not a number or whose normal has no unit length.
struct Looked {
    accuracy::Errors errors;
    render::Picture picture;
    std::int64_t hits = 0, zero_gradients = 0, crooked = 0;
    std::int64_t certain_hits = 0; // of truth
};

// Draws frame 1; a case without a size is drawn at 96 x 96. Adds a row to the table that the suite
// prints at its end.
Looked look(const HardCase& a_case, scene::Method method);

// Each wrong pixel of a picture: where it is, what is wrong, what was drawn there.
std::string wrong_pixels(const Looked& looked);

// Looks with what a scene gets that names no method, at three sizes of F and two of the scene, and
// with each method that has a bound, and expects the bounds to hold: no NaN, no ray out of steps,
// nothing crooked either.
void expect_bounds(const HardCase& a_case);

} // namespace isomotion::stability
