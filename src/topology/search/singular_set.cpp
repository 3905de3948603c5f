#include "topology/search/singular_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "topology/search/critical_system.h"

namespace isomotion::topology {
namespace {

// All in parts of the domain. A point counts as singular where F and its slopes are no more than
// `nearly` times the second derivatives around it. Another one is sought at each of the distances,
// the larger first; nearer ones must be the more singular, as the slopes of x^4 are small near 0.
constexpr double nearly = 1e-6;
constexpr std::array distances{1.0 / 16, 1.0 / 64, 1.0 / 256};
// Points further from a box are none of it.
constexpr double beside = 1e-3;
constexpr int most_starts = 16, most_iterations = 60;

class SingularPoints {
public:
    SingularPoints(const MovingField& field, const Box& box)
        : n_(std::size_t(field.variables()))
        , numbers_(field) {
        for (std::size_t k = 0; k < n_; ++k) {
            domain_[k] = field.domain()[k];
            const double whole = domain_[k].hi - domain_[k].lo;
            sides_[k] = whole > 0 ? whole : 1;
        }
        measure(box);
    }

    std::size_t clock() const { return n_ - 1; }
    const formula::Interval& times() const { return domain_[clock()]; }
    double side(std::size_t k) const { return sides_[k]; }

    // From a start, by the least squares of Levenberg and Marquardt, over the first `free`
    // variables. Steps along which nothing changes are none: they would run along the set.
    std::optional<Point> near(Point x, std::size_t free, double tolerance) {
        constexpr double least_damping = 1e-6;
        double damping = 1e-3;
        Equations now = at(x);
        for (int step = 0; step < most_iterations; ++step) {
            if (now.size <= tolerance) return x;
            Matrix squared{};
            Point slope{};
            double trace = 0;
            for (std::size_t i = 0; i < free; ++i) {
                for (std::size_t e = 0; e < n_; ++e) {
                    slope[i] += now.slopes[e][i] * now.values[e];
                    for (std::size_t j = 0; j < free; ++j)
                        squared[i][j] += now.slopes[e][i] * now.slopes[e][j];
                }
                trace += squared[i][i];
            }
            if (!(trace > 0) || !std::isfinite(trace)) return std::nullopt;
            for (std::size_t i = 0; i < free; ++i) squared[i][i] += damping * trace;
            const auto inverted = inverse(squared, int(free));
            if (!inverted) return std::nullopt;
            Point next = x;
            for (std::size_t i = 0; i < free; ++i) {
                for (std::size_t j = 0; j < free; ++j)
                    next[i] -= (*inverted)[i][j] * slope[j] * sides_[i];
            }
            const Equations then = at(next);
            if (then.size < now.size) {
                x = next;
                now = then;
                damping = std::max(damping / 10, least_damping);
            } else {
                damping *= 10;
                if (damping > 1e6) return std::nullopt;
            }
        }
        return now.size <= tolerance ? std::optional(x) : std::nullopt;
    }

private:
    // In units of the domain's sides and of the second derivatives.
    struct Equations {
        Point values{};
        Matrix slopes{};
        double size = formula::infinity;
    };

    Equations at(const Point& x) {
        Equations all;
        const Jet<double> jet = numbers_.jet(x);
        all.values = residual(jet, n_);
        all.slopes = jacobian(jet, n_);
        double squares = 0;
        for (std::size_t e = 0; e < n_; ++e) {
            const double unit = (e == 0 ? 1 : sides_[e - 1]) / scale_;
            all.values[e] *= unit;
            for (std::size_t k = 0; k < n_; ++k) all.slopes[e][k] *= unit * sides_[k];
            squares += all.values[e] * all.values[e];
        }
        if (std::isfinite(squares)) all.size = std::sqrt(squares);
        return all;
    }

    // The largest second derivative at places around the middle of the box.
    void measure(const Box& box) {
        double most = 0;
        for (int corner = 0; corner < 1 << (n_ - 1); ++corner) {
            Point x{};
            for (std::size_t k = 0; k < n_; ++k) x[k] = mid(box[k]);
            for (std::size_t k = 0; k + 1 < n_; ++k)
                x[k] += (corner >> k & 1 ? distances[0] : -distances[0]) * sides_[k];
            const Jet<double> jet = numbers_.jet(x);
            for (std::size_t i = 0; i + 1 < n_; ++i) {
                for (std::size_t k = 0; k + 1 < n_; ++k) {
                    const double here = std::abs(jet.hessian[i][k]) * sides_[i] * sides_[k];
                    if (std::isfinite(here)) most = std::max(most, here);
                }
            }
        }
        if (most > 0) scale_ = most;
    }

    std::size_t n_;
    Numbers numbers_;
    Box domain_{};
    Point sides_{};
    double scale_ = 1;
};

std::optional<Point> one_in(SingularPoints& points, const Box& box, std::size_t n) {
    for (int start = 0; start < most_starts; ++start) {
        Point x{};
        for (std::size_t k = 0; k < n; ++k) {
            // The middle first, then points spread evenly.
            const double at = 0.5 + start * std::sqrt(double(std::array{2, 3, 5, 7, 11}[k % 5]));
            x[k] = box[k].lo + (at - std::floor(at)) * (box[k].hi - box[k].lo);
        }
        const auto found = points.near(x, n, nearly);
        if (!found) continue;
        bool is_there = true;
        for (std::size_t k = 0; k < n; ++k) {
            const double reach = beside * points.side(k);
            is_there &= (*found)[k] >= box[k].lo - reach && (*found)[k] <= box[k].hi + reach;
        }
        // F itself is to be 0 at this moment where others are sought.
        if (is_there) return points.near(*found, n, 1e-4 * nearly).value_or(*found);
    }
    return std::nullopt;
}

double tolerance(double distance) {
    const double part = std::min(distance / distances[0], 1.0);
    return nearly * part * part;
}

// A point of another moment.
std::optional<Point> at_another_moment(SingularPoints& points, const Point& from) {
    const std::size_t clock = points.clock();
    for (const double distance : {1.0 / 4, 1.0 / 16, 1.0 / 64, 1.0 / 256}) {
        for (const double sign : {-1.0, 1.0}) {
            Point then = from;
            then[clock] += sign * distance * points.side(clock);
            if (!contains(points.times(), then[clock])) continue;
            // Off the place, where symmetry may hold fast.
            for (std::size_t k = 0; k < clock; ++k)
                then[k] += sign * distance * (0.3 - 0.11 * double(k)) * points.side(k);
            if (const auto other = points.near(then, clock, tolerance(distance))) return other;
        }
    }
    return std::nullopt;
}

// Ways from the point to others of its moment, about as long as the distance.
std::vector<Point> ways(SingularPoints& points, const Point& from, double distance) {
    const std::size_t d = points.clock();
    std::vector<Point> ways;
    const int directions = d == 1 ? 3 : d == 2 ? 9 : 27;
    for (int number = 0; number < directions; ++number) {
        Point start = from, along{};
        double squares = 0;
        for (int k = 0, rest = number; k < int(d); ++k, rest /= 3) {
            along[std::size_t(k)] = rest % 3 - 1;
            squares += along[std::size_t(k)] * along[std::size_t(k)];
        }
        if (squares == 0) continue;
        for (std::size_t k = 0; k < d; ++k)
            start[k] += along[k] * distance / std::sqrt(squares) * points.side(k);
        const auto other = points.near(start, d, tolerance(distance));
        if (!other) continue;
        Point way{};
        double length = 0;
        for (std::size_t k = 0; k < d; ++k) {
            way[k] = ((*other)[k] - from[k]) / points.side(k);
            length += way[k] * way[k];
        }
        length = std::sqrt(length);
        // The nearest point to a start beside a curve is nearer to where one began.
        if (length < 0.75 * distance || length > 1.5 * distance) continue;
        // Another point at that distance is no way to it: half of the way is singular, too.
        Point half = from;
        for (std::size_t k = 0; k < d; ++k) half[k] = (from[k] + (*other)[k]) / 2;
        const auto between = points.near(half, d, tolerance(distance));
        if (!between) continue;
        double off = 0;
        for (std::size_t k = 0; k < d; ++k)
            off = std::max(off, std::abs((*between)[k] - half[k]) / points.side(k));
        if (off > 0.25 * length) continue;
        for (std::size_t k = 0; k < d; ++k) way[k] /= length;
        ways.push_back(way);
    }
    return ways;
}

int dimension(SingularPoints& points, const Point& from) {
    const std::size_t d = points.clock();
    for (const double distance : distances) {
        const std::vector<Point> found = ways(points, from, distance);
        if (found.empty()) continue;
        // A quarter of all directions lead along a curve, three quarters along a surface.
        const double all = d == 1 ? 2 : d == 2 ? 8 : 26;
        const bool is_wide = std::ranges::any_of(found, [&](const Point& way) {
            double cosine = 0;
            for (std::size_t k = 0; k < d; ++k) cosine += way[k] * found[0][k];
            return std::abs(cosine) < 0.5;
        });
        return is_wide && double(found.size()) > 0.5 * all ? 2 : 1;
    }
    return 0;
}

} // namespace

std::optional<SingularSet> singular_set(const MovingField& field, const Box& box) {
    const auto n = std::size_t(field.variables());
    if (n < 2) return std::nullopt; // a corner
    SingularPoints points(field, box);
    const auto one = one_in(points, box, n);
    if (!one) return std::nullopt;
    SingularSet set{dimension(points, *one)};
    // A set that lasts may be more at one moment: lines where nodes meet.
    if (const auto other = at_another_moment(points, *one)) {
        set.lasts = true;
        set.dimension = std::min(set.dimension, dimension(points, *other));
    }
    return set;
}

} // namespace isomotion::topology
