// Thresholds of Eq. 2 for scenes that give none, derived from the field itself.
#pragma once

#include "scene/scene_at.h"

namespace isomotion::scene {

struct Thresholds {
    double near = 0, far = 0, horizon = 0;
};

// One step b off the surface F is about b |grad F|. Let g be the median of |grad F| over sample
// points near the surface: `near` is the value two steps off, `far` the value eight steps off, and
// `horizon` the slope of a ray within six degrees of the tangent plane.
Thresholds field_thresholds(const formula::Field& field, const SceneAt& scene, double step);

} // namespace isomotion::scene
