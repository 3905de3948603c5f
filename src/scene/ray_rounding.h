// Bounds the error of a ray computed in float32. Truth's tubes, the boxes around beams and the
// proofs are thickened by this bound.
//
// The exact ray of a pixel follows from the uniforms as floats, in real arithmetic. The shader's
// ray (shaders/march/ray.glsl) differs from it only by rounding. Let u = 2^-24, the relative error
// of a sum or a product. GLSL allows 5 u for a quotient and 9 u for a square root (computed as 1 /
// inversesqrt), any order of evaluation, and fused or unfused products. To first order:
//
//   at        = (pixel + shift) * (2 / size) - 1; the sum, 2 / size and the product carry u each of
//               at + 1, which is 2 at most, and the difference one of itself: 7 u
//   across    = at.x right + at.y up; a product and a sum more: 9 u of |right| + |up|, the spread S
//   anchor    = origin + across: 9 u S + u |anchor| <= 10 u S + u |origin|
//   from_eye  = axis + across: 9 u S + u |from_eye|
//   direction = from_eye / length(from_eye): its length by 5 u for the quotient, 9 u for the root
//               and 1.5 u for the squares and their sums below it, 15.5 u in all; aside by
//               u + 9 u S / |from_eye|, for normalising takes the part along it. The two are
//               perpendicular: 15.6 u + 9 u s, where s = S / depth and the depth is how far the
//               plane of the anchors is from the eye, as |from_eye| is no less. A coordinate of
//               what is aside is 1.37 times its largest coordinate before: 15.6 u + 12.3 u s.
//   point     = anchor + t direction: those of the two, and u |t| + u |point| more; a point of the
//               bounds is no farther from 0 than their centre and their radius, and the users'
//               distances are no less than the radius.
//
// The model counts 16 u for each of origin, spread, 1 and s, which leaves room for terms of u^2 and
// for depths that are rounded. It holds where no square overflows and none that matters underflows:
// lengths of 2^-50 to 2^62, whose squares and sums of three are normal floats (2^-126 to 2^127),
// and what is flushed to 0 below is less than u of the least of them.
#pragma once

#include "scene/rays.h"
#include "scene/scene_at.h"

namespace isomotion::scene {

struct RayRounding {
    double anchor = 0;
    double direction = 0; // for parallel rays s is 0
    double centre = 0;    // of points near the bounds' centre, because of its distance from 0
    double slant = 1;     // the longest way of a ray per unit of depth that it crosses
    bool holds = true;    // whether all lengths are in the range of the model

    // Error of a point of a ray at most `distance` from its anchor.
    double at_distance(double distance) const {
        return anchor + distance * (direction + 2 * unit) + centre;
    }
    // Error of a point of any ray at most `depth` from the plane of the anchors. There |t| is f
    // times the depth, f = |from_eye| / depth, and the direction is off by 15.5 u along itself and
    // u + 9 u s / f aside; f times both is less than 16 u slant, whatever s is. (Only for pictures
    // many times as wide as high, with more than 160 degrees, must the root be more accurate than 9
    // u.)
    double at_depth(double depth) const { return anchor + 18 * unit * depth * slant + centre; }

    static constexpr double unit = 0x1p-24; // relative error of one float32 rounding
};

// What is bounded: each coordinate of an error, as boxes need it; or its length, which is larger,
// as spheres and distances along rays need it.
enum class Norm { coordinate, length };

// The rays of all pixels, or of parts of pixels, of one picture.
RayRounding ray_rounding(const Rays& rays, const BoundsAt& bounds, Norm norm);

} // namespace isomotion::scene
