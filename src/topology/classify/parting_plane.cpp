#include "topology/classify/parting_plane.h"

#include <algorithm>
#include <cmath>

#include "topology/classify/curvature.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

// 0 < d^T M d for all d but 0 and all symmetric matrices M of an enclosure: by leading minors.
bool is_positive_definite(const SpaceHessian& m) {
    const Interval first = m[0][0];
    const Interval second = m[0][0] * m[1][1] - square(m[0][1]);
    const Interval third = m[0][0] * (m[1][1] * m[2][2] - square(m[1][2])) -
                           m[0][1] * (m[0][1] * m[2][2] - m[1][2] * m[0][2]) +
                           m[0][2] * (m[0][1] * m[1][2] - m[1][1] * m[0][2]);
    return first.lo > 0 && second.lo > 0 && third.lo > 0;
}

SpaceBox box_about(const SpaceBox& where, double r) {
    SpaceBox box;
    for (std::size_t k = 0; k < 3; ++k)
        box[k] = hull({mid(where[k]) - r, mid(where[k]) + r}, where[k]);
    return box;
}

// Whether the box touches no wall but those that the event is on.
bool is_off_other_walls(const SublevelSet& region, const Wall& wall, const SpaceBox& box) {
    if (wall.is_sphere()) return true;
    for (std::size_t k = 0; k < 3; ++k) {
        if (wall.free()[k] && region.may_be_on_wall(k, box[k])) return false;
    }
    return true;
}

// A plane through a sphere's centre. A great circle of it leaves the event along t = v x m, with m
// from the centre to its points; H rises along it on both sides if it bends up in the direction t,
// and into the ball from there if it rises inwards. Only parts of the box that the plane meets are
// asked.
bool parts_ball(const SublevelSet& region, const Wall& wall, const PartingPlane& plane,
                const SpaceBox& known) {
    constexpr int parts = 4;
    const auto part_of = [&](std::size_t axis, int k) {
        const Interval side = known[axis];
        const auto wall_of = [&](int at) {
            return at == parts ? side.hi : side.lo + (side.hi - side.lo) * at / parts;
        };
        return Interval(wall_of(k), wall_of(k + 1));
    };
    for (int number = 0; number < parts * parts * parts; ++number) {
        const SpaceBox part{part_of(0, number % parts), part_of(1, number / parts % parts),
                            part_of(2, number / parts / parts)};
        if (plane.side(part) != 0 || region.is_all_outside(part)) continue;
        if (!wall.rises_inwards(region, part)) return false;
        if (region.is_all_inside(part)) continue;
        const SpaceBox out = wall.from_centre(region, part);
        SpaceBox tangent;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
            tangent[i] = plane.across[j] * out[k] - plane.across[k] * out[j];
        }
        if (!(curvature(wall.bend(region, part), tangent).lo > 0)) return false;
    }
    return true;
}

SpaceHessian with_square_of(SpaceHessian bend, double more, const SpaceBox& v) {
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const Interval squared = i == j ? square(v[i]) : v[i] * v[j];
            bend[i][j] = bend[i][j] + Interval(more) * squared;
        }
    }
    return bend;
}

} // namespace

int PartingPlane::side(const SpaceBox& box) const {
    Interval height = 0;
    for (std::size_t k = 0; k < 3; ++k) height = height + across[k] * (box[k] - at[k]);
    return height.lo > 0 ? 1 : height.hi < 0 ? -1 : 0;
}

bool PartingPlane::is_around(const SpaceBox& box) const {
    for (std::size_t k = 0; k < 3; ++k) {
        if (!contains(around[k], box[k])) return false;
    }
    return true;
}

// The normal v of the plane is the direction along the wall in which H bends down. On a face, or
// inside of the bounds, B + k v v^T is positive definite over W: so H > 0 on all lines of the plane
// along the wall, but at the event. H rises from the wall into the bounds, so that H is no less
// there. What a point of W is compared with on a sphere is in a box of four times W's size: if W
// reaches r along each axis, the point is off the event by sqrt(3) r at most, off its place on the
// sphere by as much again, and the arc from the event to that place is nearer to the event than its
// end.
std::optional<PartingPlane> parting_plane(const SublevelSet& region, const Event& event) {
    const auto wall = Wall::at(region, event);
    if (!wall) return std::nullopt;
    PartingPlane plane{.at = event.where, .is_wall = event.stratum == 2 && event.index == 2};
    const SpaceHessian there = wall->bend(region, event.where);
    double scale = 0;
    for (const auto& row : there) {
        for (const Interval& entry : row) scale = std::max(scale, std::abs(mid(entry)));
    }
    const double more = 4 * scale;
    if (!plane.is_wall) plane.across = wall->along(wall->down(region, event.where));
    const double size = longest_side(region.box());
    const double reach = wall->is_sphere() ? 4 : 1;
    const double least = wall->is_sphere() ? 16 * longest_side(event.where) : 0;
    for (double r = size / 16; r > std::max(1e-7 * size, least); r /= 2) {
        const SpaceBox known = box_about(event.where, reach * r);
        plane.around = box_about(event.where, r);
        const bool is_parted =
            plane.is_wall ? is_off_other_walls(region, *wall, known) &&
                                is_positive_definite(wall->bend(region, known, more))
            : wall->is_sphere() ? parts_ball(region, *wall, plane, known)
                                : wall->rises_inwards(region, known) &&
                                      is_positive_definite(with_square_of(
                                          wall->bend(region, known, more), more, plane.across));
        if (is_parted) return plane;
    }
    return std::nullopt;
}

} // namespace isomotion::topology
