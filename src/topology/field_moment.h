// A scene's field at the time of an event, for saddle_path.h.
#pragma once

#include <memory>

#include "scene/scene_at.h"
#include "topology/saddle_path.h"

namespace isomotion::topology {

// The field's bindings enclose the values at all times of the event's enclosure; the bounds may be
// off by a billionth of their size. Not for several threads at once, and until the field is given
// other values.
Moment field_moment(std::shared_ptr<FrameField> field, const scene::BoundsAt& bounds);

} // namespace isomotion::topology
