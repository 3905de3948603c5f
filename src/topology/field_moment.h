// A scene's field at the time of an event, for saddle_path.h.
#pragma once

#include <memory>

#include "topology/enclosed_bounds.h"
#include "topology/saddle_path.h"

namespace isomotion::topology {

// The field's bindings enclose the values at all times of the event's enclosure, and so do the
// bounds. Not for several threads at once, and until the field is given other values.
Moment field_moment(std::shared_ptr<FrameField> field, const EnclosedBounds& bounds);

} // namespace isomotion::topology
