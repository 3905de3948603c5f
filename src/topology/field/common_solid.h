// What two solids of a scene have in common, as a moving solid of its own.
//
// Where A < 0 and B < 0 are the insides, it is max(A, B) < 0. It is born where the two solids touch
// and dies where they part: touching is an event on the kink of the maximum, proved like all
// others.
#pragma once

#include "formula/interval/interval.h"
#include "scene/scene.h"
#include "topology/field/motion.h"
#include "topology/field/solid.h"

namespace isomotion::topology {

// A surface, and the side that is its solid.
struct Body {
    scene::OneSurface one;
    Side side = Side::negative;
};

// The motions go by time. Coordinates and bounds are those of the first body, whose placement
// counts as at rest. The second body's bounds are a part of the formula, unless it is proved that
// they don't matter. Throws SceneError if the two have too many arrays.
Motions common_motions(const Body& first, const Body& second, formula::Interval range);

} // namespace isomotion::topology
