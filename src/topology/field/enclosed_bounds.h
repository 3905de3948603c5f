// Bounds over a short span of time: enclosures of their walls.
#pragma once

#include "scene/scene_at.h"
#include "topology/field/space_box.h"

namespace isomotion::topology {

struct EnclosedBounds {
    scene::Bounds::Shape shape = scene::Bounds::Shape::sphere;
    SpaceBox low{}, high{}; // the box's walls; for a sphere, those of the box around it
    SpaceBox centre{};      // for a sphere, as the radius
    formula::Interval radius{};
};

// Takes the bounds of one time as exact.
inline EnclosedBounds enclosed(const scene::BoundsAt& bounds) {
    EnclosedBounds exact{.shape = bounds.shape, .radius = bounds.radius};
    for (std::size_t i = 0; i < 3; ++i) {
        const int k = int(i);
        exact.low[i] = bounds.min[k];
        exact.high[i] = bounds.max[k];
        exact.centre[i] = bounds.centre[k];
    }
    return exact;
}

} // namespace isomotion::topology
