// Quadratic polynomials that grow in all directions, and their level sets: ellipsoids. Along some
// axes they may be the same everywhere: those of kernels of a distance from a line or a plane.
#pragma once

#include <array>
#include <cstdint>

#include <glm/glm.hpp>

namespace isomotion::elements {

// A box of the places that are looked at.
struct Region {
    glm::dvec3 low{-1}, high{1};

    // From a place to the corner of the region that is farthest from it.
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
    // As far as doubles can tell: no eigenvalue may be 0 but for their rounding, and the inverse is
    // right to some 1e-7. False where a number is none.
    bool is_positive() const {
        const double third = trace() / 3;
        return xx > 0 && xx * yy - xy * xy > 0 && determinant() > 1e-9 * third * third * third;
    }
    // With that for what is flat along an axis.
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

// Where an element matters. One that matters nowhere has an empty set; one of which no bound is
// known is unbounded.
struct LevelSet {
    enum class Kind : std::uint8_t { empty, bounded, unbounded };
    Kind kind = Kind::empty;
    bool is_round = false;
    // Found by intervals, for terms that are no kernels of a polynomial: a box, of which cells may
    // be met or not.
    bool is_box = false;
    glm::dvec3 centre{0};
    glm::dvec3 half{0}; // of the box around it; beyond the region along a flat axis
    glm::bvec3 is_flat{false};
    Symmetric form;             // at most 1 inside, of places relative to the centre
    double least = 0, rise = 0; // the polynomial is least + rise * form
};

// A polynomial P = sign * Q, the sign such that P grows outwards.
struct Quadric {
    bool is_definite = false;
    double sign = 1;
    double least = 0; // of P anywhere
    double most = 0;  // of P in the region and far around it
    // P is at least `least` + flattest * (distance from the centre)^2, the distance across the axes
    // along which it is flat. There the centre is in the middle of the region.
    double flattest = 0;
    glm::dvec3 centre{0};
    glm::bvec3 is_flat{false};
    double width = 0;  // of the region
    Symmetric hessian; // of P

    // From the value, the gradient and the Hessian of Q at the origin. Rounded doubles: least and
    // most leave room for that.
    static Quadric from(const std::array<double, 10>& coefficients, const Region& region);
    // Where P is at most that, and a millionth of the distance beyond.
    LevelSet level_set(double level) const;
};

} // namespace isomotion::elements
