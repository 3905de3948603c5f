#include "elements/quadric.h"

#include <cmath>

namespace isomotion::elements {
namespace {

// Factor of distances: level sets are as much larger as coefficients may be rounded.
constexpr double margin = 1 + 1e-6;
// Levels are looked for so far beyond the region: a support as large as the scene has its end
// there.
constexpr double wider = 64;

} // namespace

Symmetric Symmetric::inverse() const {
    const Symmetric minors{yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy,
                           xx * zz - xz * xz, xy * xz - xx * yz, xx * yy - xy * xy};
    return 1 / determinant() * minors;
}

Quadric Quadric::from(const std::array<double, 10>& q, const Region& region) {
    Quadric made;
    made.sign = q[4] < 0 || q[7] < 0 || q[9] < 0 ? -1 : 1;
    made.hessian = made.sign * Symmetric{q[4], q[5], q[6], q[7], q[8], q[9]};
    const Symmetric& h = made.hessian;
    const glm::dvec3 slope = made.sign * glm::dvec3(q[1], q[2], q[3]);
    made.is_flat = {h.xx == 0 && h.xy == 0 && h.xz == 0 && slope.x == 0,
                    h.yy == 0 && h.xy == 0 && h.yz == 0 && slope.y == 0,
                    h.zz == 0 && h.xz == 0 && h.yz == 0 && slope.z == 0};
    const double trace = h.trace();
    const Symmetric filled = h.filled(made.is_flat, trace);
    if (glm::all(made.is_flat) || !filled.is_positive()) return made;
    const Symmetric inverse = filled.inverse();
    made.centre = -(inverse * slope);
    made.width = glm::length(region.high - region.low);
    for (int k = 0; k < 3; ++k) {
        if (made.is_flat[k]) made.centre[k] = 0.5 * (region.low[k] + region.high[k]);
    }
    // A difference of larger numbers, which are rounded.
    const double value = made.sign * q[0], fall = 0.5 * glm::dot(slope, made.centre);
    made.least = value + fall - 1e-12 * (std::abs(value) + std::abs(fall));
    const double reach = margin * wider * region.farthest(made.centre);
    made.most =
        made.least + 0.5 * trace * reach * reach + 1e-9 * (std::abs(value) + std::abs(fall));
    // The least eigenvalue is at least that of 1 over the inverse's trace.
    const double flat = double(made.is_flat.x) + double(made.is_flat.y) + double(made.is_flat.z);
    made.flattest = h.is_round() ? 0.5 * h.xx : 0.5 / (inverse.trace() - flat / trace);
    made.is_definite = std::isfinite(made.most) && made.flattest > 0 && made.most > made.least;
    return made;
}

LevelSet Quadric::level_set(double level) const {
    LevelSet set;
    const double height = margin * margin * 2 * (level - least);
    if (!(height > 0)) return set;
    const Symmetric inverse = hessian.filled(is_flat).inverse();
    set.is_flat = is_flat;
    set.is_round = hessian.is_round();
    set.centre = centre;
    set.half = glm::sqrt(height * glm::dvec3(inverse.xx, inverse.yy, inverse.zz));
    for (int k = 0; k < 3; ++k) {
        if (is_flat[k]) set.half[k] = width;
    }
    set.form = 1 / height * hessian;
    set.least = least;
    set.rise = 0.5 * height;
    const bool is_finite = glm::all(glm::lessThan(set.half, glm::dvec3(1e300)));
    set.kind = is_finite ? LevelSet::Kind::bounded : LevelSet::Kind::unbounded;
    return set;
}

} // namespace isomotion::elements
