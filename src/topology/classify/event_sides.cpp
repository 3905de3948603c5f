#include "topology/classify/event_sides.h"

#include <algorithm>
#include <cmath>

#include "formula/interval/interval_operations.h"
#include "topology/classify/curvature.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

using Both = std::array<SpacePoint, 2>;

// Parts of the bounds: the first and the least distance from the event that is tried; how far
// inside of a wall a side is.
constexpr double first = 1.0 / 32, least = 1e-9, inset = 1e-7;

bool curves_down(const SpaceHessian& h, const SpaceBox& d) { return curvature(h, d).hi < 0; }

// Whether all of a box is proved to be in the region, by H over it or by H's gradient from the
// middle.
bool holds(const SublevelSet& region, const SpaceBox& box) {
    const SpacePoint at = middle(box);
    const ValueAndGradient h = region.over({&box, 1}).front();
    const SpaceBox centre = point_box(at);
    Interval value = region.values({&centre, 1}).front();
    for (std::size_t i = 0; i < 3; ++i) value = value + h.gradient[i] * (box[i] - Interval(at[i]));
    return h.value.hi < 0 || value.hi < 0;
}

// From a place on the walls a little into the bounds; none where that is not proved to be in the
// region.
std::optional<SpacePoint> inside_of(const SublevelSet& region, const SpaceBox& on_wall) {
    SpacePoint inside = middle(on_wall);
    for (std::size_t i = 0; i < 3; ++i) inside[i] += inset * (mid(region.box()[i]) - inside[i]);
    if (!holds(region, hull_of(on_wall, point_box(inside))) || !region.may_hold(inside))
        return std::nullopt;
    return inside;
}

// With H = 0 and no gradient at the critical point p, H(p + s d) = s^2/2 d^T H'' d for second
// derivatives at some point of the segment: negative on all of it if they bend down over a box
// around it. That the directions to both, one turned round, are together in a box on which H'' at p
// bends down says that they are in different nappes.
std::optional<Both> along_lines(const SublevelSet& region, const Event& event, const Wall& wall) {
    const SpaceBox& where = event.where;
    const std::array<bool, 3>& free = wall.free();
    const SpaceHessian hessian = region.hessian(where);
    const SpacePoint direction = wall.down(region, event.where), centre = middle(where);
    const auto step_to = [&](const SpacePoint& q, double sign) {
        SpaceBox d;
        for (std::size_t i = 0; i < 3; ++i)
            d[i] = free[i] ? Interval(sign) * (Interval(q[i]) - where[i]) : Interval(0);
        return d;
    };
    const double reach = longest_side(region.box());
    for (double r = first * reach; r > least * reach; r /= 2) {
        const SpacePoint a = along(centre, r, direction), b = along(centre, -r, direction);
        const SpaceBox da = step_to(a, 1), db = step_to(b, -1);
        if (!curves_down(hessian, hull_of(da, db))) continue;
        if (!curves_down(region.hessian(hull_of(where, point_box(a))), da)) continue;
        if (!curves_down(region.hessian(hull_of(where, point_box(b))), db)) continue;
        Both sides{a, b};
        if (event.stratum < 3) {
            // On a wall they are in the bounds as the event is; from there a little inwards.
            for (SpacePoint& side : sides) {
                SpaceBox on_wall = point_box(side);
                for (std::size_t i = 0; i < 3; ++i) {
                    if (!free[i]) on_wall[i] = where[i];
                }
                const auto inside = inside_of(region, on_wall);
                if (!inside) return std::nullopt;
                side = *inside;
            }
        }
        if (region.may_hold(sides[0]) && region.may_hold(sides[1])) return sides;
    }
    return std::nullopt;
}

// An arc of a great circle from each point of the event's box, in a direction u along the sphere:
// c + r (cos a n + sin a u), for unit vectors n and u.
struct Arc {
    SpaceBox all, end; // enclosures
    SpaceBox tangent;  // of unit tangents
};

Arc arc_of(const EnclosedBounds& bounds, const SpaceBox& n, const SpaceBox& u, double half_angle) {
    const Interval tan(half_angle), one(1), more = one + square(tan);
    const Interval cos = (one - square(tan)) / more, sin = Interval(2) * tan / more;
    const Interval all_cos(cos.lo, 1), all_sin(0, sin.hi);
    Arc arc;
    for (std::size_t i = 0; i < 3; ++i) {
        arc.all[i] = bounds.centre[i] + bounds.radius * (all_cos * n[i] + all_sin * u[i]);
        arc.end[i] = bounds.centre[i] + bounds.radius * (cos * n[i] + sin * u[i]);
        arc.tangent[i] = all_cos * u[i] - all_sin * n[i];
    }
    return arc;
}

// The same along great circles: both arcs leave p in opposite directions u and -u.
std::optional<Both> along_sphere(const SublevelSet& region, const Event& event, const Wall& wall) {
    SpaceBox u = wall.along(wall.down(region, event.where));
    const Interval length =
        formula::Operations<Interval>::sqrt(square(u[0]) + square(u[1]) + square(u[2]));
    if (!(length.lo > 0.5)) return std::nullopt;
    for (Interval& part : u) part = part / length;
    const SpaceBox back{-u[0], -u[1], -u[2]};
    const double reach = longest_side(region.box()), radius = mid(region.bounds().radius);
    for (double r = first * reach; r > least * reach; r /= 2) {
        const double half_angle = r / (2 * radius);
        if (!(half_angle < 0.5)) continue;
        const std::array arcs{arc_of(region.bounds(), wall.outwards(), u, half_angle),
                              arc_of(region.bounds(), wall.outwards(), back, half_angle)};
        const bool are_down = std::ranges::all_of(arcs, [&](const Arc& arc) {
            return curves_down(wall.bend(region, arc.all), arc.tangent);
        });
        if (!are_down) continue;
        const auto a = inside_of(region, arcs[0].end), b = inside_of(region, arcs[1].end);
        if (!a || !b) return std::nullopt;
        return Both{*a, *b};
    }
    return std::nullopt;
}

// From each point of the event's box to the first side H falls from 0 on.
std::optional<Both> inside_and_outside(const SublevelSet& region, const Event& event,
                                       const Wall& wall) {
    const SpaceBox& where = event.where;
    const SpacePoint centre = middle(where), out = middle(wall.outwards());
    const double reach = longest_side(region.box());
    const SpacePoint outside = along(centre, first * reach, out);
    if (!region.is_outside(point_box(outside))) return std::nullopt;
    for (double r = first * reach; r > least * reach; r /= 2) {
        const SpacePoint inside = along(centre, -r, out);
        const SpaceBox way = hull_of(where, point_box(inside));
        const SpaceBox slopes = region.over({&way, 1}).front().gradient;
        Interval rise = 0;
        for (std::size_t i = 0; i < 3; ++i)
            rise = rise + slopes[i] * (Interval(inside[i]) - where[i]);
        if (rise.hi < 0 && region.is_inside(inside)) return Both{inside, outside};
    }
    return std::nullopt;
}

} // namespace

std::optional<std::array<SpacePoint, 2>> both_sides(const SublevelSet& region, const Event& event) {
    const auto wall = Wall::at(region, event);
    if (!wall) return std::nullopt;
    if (event.stratum == 2 && event.index == 2) return inside_and_outside(region, event, *wall);
    return wall->is_sphere() ? along_sphere(region, event, *wall)
                             : along_lines(region, event, *wall);
}

} // namespace isomotion::topology
