#include "topology/saddle_path.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace isomotion::topology {
namespace {

using formula::Interval;

SpaceBox point_box(const SpacePoint& p) { return {p[0], p[1], p[2]}; }

SpaceBox hull_of(const SpaceBox& a, const SpaceBox& b) {
    return {hull(a[0], b[0]), hull(a[1], b[1]), hull(a[2], b[2])};
}

SpacePoint middle(const SpaceBox& box) { return {mid(box[0]), mid(box[1]), mid(box[2])}; }

double length(const SpacePoint& v) { return std::hypot(v[0], v[1], v[2]); }

SpacePoint along(const SpacePoint& p, double step, const SpacePoint& direction) {
    SpacePoint q;
    for (std::size_t i = 0; i < 3; ++i) q[i] = p[i] + step * direction[i];
    return q;
}

// The unit eigenvector of the least eigenvalue of a symmetric matrix, by Jacobi's rotations. Axes
// that are not free take no part.
SpacePoint least_direction(std::array<std::array<double, 3>, 3> a,
                           const std::array<bool, 3>& free) {
    std::array<std::array<double, 3>, 3> columns{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (int sweep = 0; sweep < 30; ++sweep) {
        for (std::size_t p = 0; p < 3; ++p) {
            for (std::size_t q = p + 1; q < 3; ++q) {
                if (!free[p] || !free[q] || a[p][q] == 0) continue;
                const double angle = 0.5 * std::atan2(2 * a[p][q], a[q][q] - a[p][p]);
                const double c = std::cos(angle), s = std::sin(angle);
                const auto rotate = [&](double& x, double& y) {
                    const double turned = c * x - s * y;
                    y = s * x + c * y;
                    x = turned;
                };
                for (std::size_t k = 0; k < 3; ++k) rotate(a[k][p], a[k][q]);
                for (std::size_t k = 0; k < 3; ++k) rotate(a[p][k], a[q][k]);
                for (std::size_t k = 0; k < 3; ++k) rotate(columns[k][p], columns[k][q]);
            }
        }
    }
    std::optional<std::size_t> least;
    for (std::size_t k = 0; k < 3; ++k) {
        if (free[k] && (!least || a[k][k] < a[*least][*least])) least = k;
    }
    SpacePoint direction{};
    if (!least) return direction;
    for (std::size_t k = 0; k < 3; ++k) direction[k] = columns[k][*least];
    return direction;
}

// The region whose parts are to be joined: H < 0 in the bounds, H being G; or H = -G < 0 and all
// that is outside of them.
class Region {
public:
    Region(const Moment& moment, bool is_solid)
        : moment_(moment)
        , is_solid_(is_solid) {}

    bool is_solid() const { return is_solid_; }
    const SpaceBox& box() const { return moment_.box; }

    std::vector<ValueAndGradient> over(std::span<const SpaceBox> boxes) const {
        std::vector<ValueAndGradient> h(boxes.size());
        moment_.over(boxes, h);
        if (!is_solid_) {
            for (ValueAndGradient& one : h) {
                one.value = -one.value;
                for (Interval& slope : one.gradient) slope = -slope;
            }
        }
        return h;
    }
    ValueAndGradient over(const SpaceBox& box) const { return over(std::span(&box, 1)).front(); }
    // Of each box: H < 0 by its value alone.
    std::vector<bool> hold(std::span<const SpaceBox> boxes) const {
        std::vector<Interval> values(boxes.size());
        moment_.values(boxes, values);
        std::vector<bool> held;
        for (const Interval& g : values) held.push_back(is_solid_ ? g.hi < 0 : g.lo > 0);
        return held;
    }
    SpaceHessian hessian(const SpaceBox& box) const {
        SpaceHessian h = moment_.hessian(box);
        if (!is_solid_) {
            for (auto& row : h) {
                for (Interval& entry : row) entry = -entry;
            }
        }
        return h;
    }

    // Points that a path may have for corners. Between two of them it is inside of the bounds, for
    // these are convex.
    bool may_hold(const SpacePoint& p) const { return !is_solid_ || moment_.is_inside(p); }
    bool is_outside(const SpaceBox& box) const { return !is_solid_ && moment_.is_outside(box); }
    // Proved to be in the region but for the bounds.
    bool holds(const SpaceBox& box) const {
        if (is_outside(box)) return true;
        const ValueAndGradient h = over(box);
        if (h.value.hi < 0) return true;
        const SpacePoint at = middle(box);
        Interval value = over(point_box(at)).value;
        for (std::size_t i = 0; i < 3; ++i)
            value = value + h.gradient[i] * (box[i] - Interval(at[i]));
        return value.hi < 0;
    }

private:
    const Moment& moment_;
    bool is_solid_;
};

// d^T H d < 0 for all of both.
bool bends_down(const SpaceHessian& h, const SpaceBox& d) {
    Interval sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        sum = sum + h[i][i] * square(d[i]);
        for (std::size_t j = i + 1; j < 3; ++j) sum = sum + Interval(2) * h[i][j] * (d[i] * d[j]);
    }
    return sum.hi < 0;
}

// The coordinates that are free on the event's stratum: those farthest from the walls.
std::array<bool, 3> free_axes(const Event& event, const SpaceBox& box) {
    std::array<std::size_t, 3> axes{0, 1, 2};
    const auto to_wall = [&](std::size_t i) {
        const double at = mid(event.where[i]);
        return std::min(std::abs(at - box[i].lo), std::abs(at - box[i].hi));
    };
    std::ranges::sort(axes, std::greater{}, to_wall);
    std::array<bool, 3> free{};
    for (int k = 0; k < event.stratum; ++k) free[axes[std::size_t(k)]] = true;
    return free;
}

// Points on both sides of the saddle, each joined to it by a segment in the region. With H = 0 and
// no gradient at the critical point p, H(p + s d) = s^2/2 d^T H'' d for second derivatives at some
// point of the segment: negative on all of it if they bend down over a box around it. That the
// directions to both, one turned round, are together in a box on which H'' at p bends down says
// that they are in different nappes.
std::optional<std::array<SpacePoint, 2>> both_sides(const Region& region, const Event& event) {
    const SpaceBox& where = event.where;
    const std::array<bool, 3> free = free_axes(event, region.box());
    const SpaceHessian bend = region.hessian(where);
    std::array<std::array<double, 3>, 3> numbers;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) numbers[i][j] = mid(bend[i][j]);
    }
    const SpacePoint direction = least_direction(numbers, free);
    const SpacePoint centre = middle(where);
    const auto step_to = [&](const SpacePoint& q, double sign) {
        SpaceBox d;
        for (std::size_t i = 0; i < 3; ++i)
            d[i] = free[i] ? Interval(sign) * (Interval(q[i]) - where[i]) : Interval(0);
        return d;
    };
    double reach = 0;
    for (const Interval& side : region.box()) reach = std::max(reach, side.hi - side.lo);
    for (double r = reach / 32; r > reach * 1e-9; r /= 2) {
        const SpacePoint a = along(centre, r, direction), b = along(centre, -r, direction);
        const SpaceBox da = step_to(a, 1), db = step_to(b, -1);
        if (!bends_down(bend, hull_of(da, db))) continue;
        if (!bends_down(region.hessian(hull_of(where, point_box(a))), da)) continue;
        if (!bends_down(region.hessian(hull_of(where, point_box(b))), db)) continue;
        // On a wall they are in the bounds as the event is.
        if (event.stratum == 3 && (!region.may_hold(a) || !region.may_hold(b))) continue;
        return std::array{a, b};
    }
    return std::nullopt;
}

// A path down from a point, each step in a box that is in the region, along the axes that are free.
struct Descent {
    std::vector<SpacePoint> points;
    bool leaves_bounds = false;
};

Descent descend(const Region& region, const SpacePoint& from, const std::array<bool, 3>& free,
                double step, double longest) {
    Descent path{{from}};
    constexpr int most_steps = 400;
    for (int k = 0; k < most_steps; ++k) {
        const SpacePoint p = path.points.back();
        if (region.is_outside(point_box(p))) {
            path.leaves_bounds = true;
            break;
        }
        const auto slopes = region.over(point_box(p)).gradient;
        SpacePoint down{-mid(slopes[0]), -mid(slopes[1]), -mid(slopes[2])};
        for (std::size_t i = 0; i < 3; ++i) {
            if (!free[i]) down[i] = 0;
        }
        const double steepness = length(down);
        if (!(steepness > 0)) break;
        for (double& c : down) c /= steepness;
        SpacePoint q = along(p, step, down);
        int halvings = 0;
        while (halvings < 30 &&
               (!region.may_hold(q) || !region.holds(hull_of(point_box(p), point_box(q))))) {
            step /= 2;
            q = along(p, step, down);
            ++halvings;
        }
        if (halvings == 30 || step < 1e-6 * longest) break;
        path.points.push_back(q);
        step = std::min(longest, 1.6 * step);
    }
    return path;
}

// Cells of a grid that are proved to be in the region, asked for as needed, joined by faces. One
// layer of cells is around the box.
class Cells {
public:
    using Cell = std::array<int, 3>;

    Cells(const Region& region, int cells)
        : region_(region) {
        for (const Interval& side : region.box())
            size_ = std::max(size_, (side.hi - side.lo) / cells);
        for (std::size_t i = 0; i < 3; ++i)
            count_[i] = int(std::ceil((region.box()[i].hi - region.box()[i].lo) / size_));
    }

    double size() const { return size_; }

    // The cell that a descent ends up in, if some cell it goes through is in the region.
    std::optional<Cell> start(const Descent& path) {
        if (path.leaves_bounds) return Cell{-1, -1, -1}; // as all cells around the box
        for (auto p = path.points.rbegin(); p != path.points.rend(); ++p) {
            Cell cell;
            for (std::size_t i = 0; i < 3; ++i)
                cell[i] = int(std::floor(((*p)[i] - region_.box()[i].lo) / size_));
            if (!is_in_grid(cell) || !region_.may_hold(centre(cell))) continue;
            const SpaceBox wide = hull_of(box(cell), point_box(*p)); // the cell is rounded
            if (region_.holds(wide)) return cell;
        }
        return std::nullopt;
    }

    // Floods from both, by turns, until they meet or one is all there is; gives up where that is
    // too many.
    bool joins(const Cell& a, const Cell& b) {
        if (a == b || (is_around(a) && is_around(b))) return true;
        enum : char { unseen, seen, of_a, of_b }; // seen: not in the region
        std::vector<char> known(place({count_[0], count_[1], count_[2]}) + 1, unseen);
        constexpr std::array sides{of_a, of_b};
        known[place(a)] = of_a;
        known[place(b)] = of_b;
        std::array<std::vector<Cell>, 2> front{{{a}, {b}}};
        std::size_t cells = 2;
        for (;;) {
            const std::size_t now = front[0].size() <= front[1].size() ? 0 : 1;
            if (front[now].empty() || cells > most_cells) return false;
            std::vector<Cell> candidates;
            for (const Cell& cell : front[now]) {
                for (std::size_t i = 0; i < 3; ++i) {
                    for (int step : {-1, 1}) {
                        Cell next = cell;
                        next[i] += step;
                        if (!is_in_grid(next)) continue;
                        char& of_next = known[place(next)];
                        if (of_next == sides[1 - now]) return true;
                        if (of_next != unseen) continue;
                        of_next = seen;
                        candidates.push_back(next);
                    }
                }
            }
            cells += candidates.size();
            front[now] = in_region(candidates);
            for (const Cell& cell : front[now]) known[place(cell)] = sides[now];
        }
    }

private:
    static constexpr std::size_t most_cells = 200'000;

    std::size_t place(const Cell& cell) const {
        std::size_t place = 0;
        for (std::size_t i = 0; i < 3; ++i)
            place = place * std::size_t(count_[i] + 2) + std::size_t(cell[i] + 1);
        return place;
    }
    bool is_in_grid(const Cell& cell) const {
        for (std::size_t i = 0; i < 3; ++i) {
            if (cell[i] < -1 || cell[i] > count_[i]) return false;
        }
        return true;
    }
    bool is_around(const Cell& cell) const {
        for (std::size_t i = 0; i < 3; ++i) {
            if (cell[i] < 0 || cell[i] >= count_[i]) return true;
        }
        return false;
    }
    double wall(std::size_t axis, int index) const {
        // Cells around the box are to be outside of it, also when rounded.
        if (index < 0) return region_.box()[axis].lo - size_;
        return region_.box()[axis].lo + index * size_ + (index >= count_[axis] ? 1e-9 * size_ : 0);
    }
    SpaceBox box(const Cell& cell) const {
        SpaceBox box;
        for (std::size_t i = 0; i < 3; ++i) box[i] = {wall(i, cell[i]), wall(i, cell[i] + 1)};
        return box;
    }
    SpacePoint centre(const Cell& cell) const { return middle(box(cell)); }

    std::vector<Cell> in_region(const std::vector<Cell>& cells) const {
        std::vector<Cell> found, asked;
        std::vector<SpaceBox> boxes;
        for (const Cell& cell : cells) {
            if (!region_.is_solid() && (is_around(cell) || region_.is_outside(box(cell)))) {
                found.push_back(cell);
            } else if (region_.may_hold(centre(cell))) {
                asked.push_back(cell);
                boxes.push_back(box(cell));
            }
        }
        const std::vector<bool> are_in = region_.hold(boxes);
        for (std::size_t k = 0; k < asked.size(); ++k) {
            if (are_in[k]) found.push_back(asked[k]);
        }
        return found;
    }

    const Region& region_;
    double size_ = 0;
    Cell count_{};
};

} // namespace

bool sides_are_joined(const Moment& moment, const Event& event, int cells) {
    const bool is_solid = event.index == 1;
    // Of a critical point of index 2 on a wall the sides are the inside and the outside.
    if (event.index != 1 && (event.index != 2 || event.stratum != 3)) return false;
    const Region region(moment, is_solid);
    const auto sides = both_sides(region, event);
    if (!sides) return false;
    Cells grid(region, cells);
    std::array<Cells::Cell, 2> starts;
    for (std::size_t k = 0; k < 2; ++k) {
        const SpacePoint& side = (*sides)[k];
        SpacePoint away;
        for (std::size_t i = 0; i < 3; ++i) away[i] = side[i] - mid(event.where[i]);
        // On a wall the side is where the wall is; from there a little inwards.
        const std::array<bool, 3> free = free_axes(event, moment.box);
        SpaceBox on_wall = point_box(side);
        SpacePoint from = side;
        for (std::size_t i = 0; i < 3; ++i) {
            if (free[i]) continue;
            on_wall[i] = event.where[i];
            from[i] += 1e-7 * (mid(moment.box[i]) - side[i]);
        }
        if (event.stratum < 3 && !region.holds(hull_of(on_wall, point_box(from)))) return false;
        const Descent path = descend(region, from, free, length(away) / 4, grid.size());
        const auto start = grid.start(path);
        if (!start) return false;
        starts[k] = *start;
    }
    return grid.joins(starts[0], starts[1]);
}

} // namespace isomotion::topology
