// Events at a knot of the animation, where the motion goes on by another rule.
//
// The formulas of both sides agree at the knot. If each has one critical point in a box around the
// place at all times nearby, the two are the same one at the knot, and its value passes 0 once if
// it rises on both sides, or falls.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "topology/field/moving_field.h"
#include "topology/field/space_box.h"

namespace isomotion::topology {

// A proved critical point that may be at the knot, of the formula of one side.
struct KnotPoint {
    std::shared_ptr<const MovingField> field; // in a frame that rests
    Box where;                                // of the field
    double knot = 0;                          // on its clock
    int part = 0;                             // the same for strata of one box, or of one chart
    int index_across = 0;                     // of its kinks
    std::vector<char> path;                   // identifies its formula among those of kinks
    // Of the place in space, and when.
    formula::Interval time;
    SpaceBox place;
};

// What is certain of two critical points of one knot that are the same one there.
struct AtKnot {
    int index = 0; // of F along the stratum
    bool changes_solid = true;
    int rises = 0; // 1: F rises in time on both sides, -1: it falls; 0: it comes to 0 and goes back
};

// None if they may be two.
std::optional<AtKnot> meet(const KnotPoint& before, const KnotPoint& after);

} // namespace isomotion::topology
