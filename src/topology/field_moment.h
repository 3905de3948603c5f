// A scene's field at the time of an event, for saddle_path.h.
#pragma once

#include "scene/scene_at.h"
#include "topology/saddle_path.h"

namespace isomotion::topology {

// The formula's bindings enclose the values at all times of the event's enclosure; the bounds may
// be off by a billionth of their size. Not for several threads at once.
Moment field_moment(const SpaceFormula& formula, const scene::BoundsAt& bounds);

} // namespace isomotion::topology
