// The size of a field's values, and the thresholds of Eq. 2 for scenes that give none.
#pragma once

#include "scene/scene_at.h"

namespace isomotion::probe {

struct Thresholds {
    double near = 0, far = 0, horizon = 0;
};

// The median of |grad F| over sample points near the surface; 0 if the gradient is 0 at all of
// them.
double field_slope(const formula::Field& field, const scene::SurfaceAt& surface);

// One step b off the surface |F| is about b |grad F|. `near` is the value two steps off, `far` the
// value eight steps off, and `horizon` the slope of a ray within six degrees of the tangent plane.
Thresholds field_thresholds(double slope, double step);

// The power of two to multiply F with (Field::scale), so that float32 neither overflows nor
// underflows on the way to a verdict. It is 1 if F's slope near the surface is moderate. Otherwise
// it scales the slope to 1, which keeps all that a march takes, F as its second derivative, within
// float32, whatever the size of the bounds; only part of the way where a tenth of the slopes would
// be lost by that. Scaling a field times 2^k gives the same field.
double field_scale(const formula::Field& field, const scene::SurfaceAt& surface);

struct Float32Loss {
    double part = 0;    // of sample points: those where float32 can't represent F
    double example = 0; // one such value of F, for the user's formula
};

Float32Loss float32_loss(const formula::Field& field, const scene::SurfaceAt& surface);

// How far from where it is float32 finds the surface, in radii of the bounds: the median over
// sample points near it. Infinite if there are none.
double float32_displacement(const formula::Field& field, const scene::SurfaceAt& surface);

// At so many radii of the bounds coordinates in float32 are off by a 64th of a pixel, in pictures 512
// pixels high.
inline constexpr double far_radii = 1000;
// Whether bounds lie so far from the origin.
bool is_far(const scene::BoundsAt& bounds);

} // namespace isomotion::probe
