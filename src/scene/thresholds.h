// How large a field's values are, and the thresholds of Eq. 2 for scenes that give none.
#pragma once

#include "scene/scene_at.h"

namespace isomotion::scene {

struct Thresholds {
    double near = 0, far = 0, horizon = 0;
};

// The median of |grad F| over sample points near the surface; 0 of a field without slope at any.
double field_slope(const formula::Field& field, const SceneAt& scene);

// One step b off the surface F is about b |grad F|: `near` is the value two steps off, `far` the
// value eight steps off, and `horizon` the slope of a ray within six degrees of the tangent plane.
Thresholds field_thresholds(double slope, double step);

// A power of two to multiply F with (Field::scale), so that float32 neither overflows nor
// underflows on the way to a verdict: 1 where F's slope near the surface is moderate, and else what
// brings it to 1. A field times 2^k, scaled, is the same field.
double field_scale(const formula::Field& field, const SceneAt& scene);

struct Float32Loss {
    double part = 0;    // of sample points: where float32 doesn't hold F
    double example = 0; // of F's values, as the user's formula has them
};

Float32Loss float32_loss(const formula::Field& field, const SceneAt& scene);

} // namespace isomotion::scene
