// Quadratic polynomials that grow in all directions, and their level sets: ellipsoids. They may be
// constant along some axes, as for kernels of a distance from a line or a plane.
#pragma once

#include <array>
#include <cstdint>

#include <glm/glm.hpp>

namespace isomotion::elements {

// The box of places that are of interest.
struct Region {
    glm::dvec3 low{-1}, high{1};

    // The distance from a place to the farthest corner of the region.
    double farthest(const glm::dvec3& from) const {
        return glm::length(glm::max(glm::abs(low - from), glm::abs(high - from)));
    }
};

// xx xy xz yy yz zz
struct Symmetric {
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

    double trace() const { return xx + yy + zz; }
    double determinant() const {
        return xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
    }
    // Whether the matrix is positive definite, as far as doubles can tell: no eigenvalue is within
    // rounding of 0, and the inverse is accurate to some 1e-7. False if an entry is NaN.
    bool is_positive() const {
        const double third = trace() / 3;
        return xx > 0 && xx * yy - xy * xy > 0 && determinant() > 1e-9 * third * third * third;
    }
    // Sets the diagonal entries of axes along which it is flat.
    Symmetric filled(const glm::bvec3& is_flat, double flat = 1) const {
        Symmetric all = *this;
        if (is_flat.x) all.xx = flat;
        if (is_flat.y) all.yy = flat;
        if (is_flat.z) all.zz = flat;
        return all;
    }
    bool is_round() const { return xy == 0 && xz == 0 && yz == 0 && xx == yy && yy == zz; }
    Symmetric inverse() const;
    glm::dvec3 operator*(const glm::dvec3& v) const {
        return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z,
                xz * v.x + yz * v.y + zz * v.z};
    }
};

inline Symmetric operator*(double s, const Symmetric& a) {
    return {s * a.xx, s * a.xy, s * a.xz, s * a.yy, s * a.yz, s * a.zz};
}

// The places where an element matters. The set is empty if it matters nowhere, unbounded if no
// bound is known.
struct LevelSet {
    enum class Kind : std::uint8_t { empty, bounded, unbounded };
    Kind kind = Kind::empty;
    bool is_round = false;
    // A box found by intervals, for terms that aren't kernels of a polynomial. Cells in it may or
    // may not be met.
    bool is_box = false;
    glm::dvec3 centre{0};
    // Half the sides of its bounding box; extends beyond the region along a flat axis.
    glm::dvec3 half{0};
    glm::bvec3 is_flat{false};
    Symmetric form;             // of places relative to the centre; at most 1 inside
    double least = 0, rise = 0; // the polynomial is least + rise * form
};

// A polynomial P = sign * Q, the sign such that P grows outwards.
struct Quadric {
    bool is_definite = false;
    double sign = 1;
    double least = 0; // minimum of P anywhere
    double most = 0;  // maximum of P in the region and far around it
    // P is at least `least` + flattest * (distance from the centre)^2, with the distance measured
    // across the axes along which P is flat. Along those the centre is in the middle of the region.
    double flattest = 0;
    glm::dvec3 centre{0};
    glm::bvec3 is_flat{false};
    double width = 0;  // of the region
    Symmetric hessian; // of P

    // From the value, the gradient and the Hessian of Q at the origin. Doubles are rounded; `least`
    // and `most` have a margin for that.
    static Quadric from(const std::array<double, 10>& coefficients, const Region& region);
    // The set where P is at most `level`, extended by a millionth of the distance.
    LevelSet level_set(double level) const;
};

} // namespace isomotion::elements
