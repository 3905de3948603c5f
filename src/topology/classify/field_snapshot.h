// The field and the bounds at the time of an event.
#pragma once

#include <functional>
#include <memory>
#include <span>

#include "topology/field/enclosed_bounds.h"
#include "topology/field/frame_field.h"
#include "topology/field/space_point.h"

namespace isomotion::topology {

// G at the time of an event, in formula coordinates. Enclosures hold for all times in Event::time.
// The bounds are convex and lie in `box`; both tests are proofs.
struct FieldSnapshot {
    std::function<void(std::span<const SpaceBox>, std::span<ValueAndGradient>)> over;
    std::function<void(std::span<const SpaceBox>, std::span<formula::Interval>)> values;
    // Narrows enclosures to second order.
    std::function<void(std::span<const SpaceBox>, std::span<ValueAndGradient>)> tighten;
    std::function<SpaceHessian(const SpaceBox&)> hessian;
    SpaceBox box;
    EnclosedBounds bounds;
    std::function<bool(const SpacePoint&)> is_inside;
    std::function<bool(const SpaceBox&)> is_outside;
};

// The field's bindings and the bounds must enclose the values at all times of the event's
// enclosure. Use it from one thread, until the field is bound to other values.
FieldSnapshot field_snapshot(std::shared_ptr<FrameField> field, const EnclosedBounds& bounds);

} // namespace isomotion::topology
