#include "topology/classify/descent.h"

#include <algorithm>

namespace isomotion::topology {
namespace {

// The first step as a part of the longest; parts of the box: what Newton's step is at a minimum,
// and where a step gives up.
constexpr double initial = 2.0 / 15, at_rest = 1e-7, shortest = 1e-9;
constexpr int most_steps = 300;
// From one step to the next the slope turns by less than the angle of this cosine.
constexpr double straight = 0.3;

// One way, a step at a time: the point that it tries, and what it makes of the field there.
class Walker {
public:
    Walker(const Domain& domain, double size, const Start& start)
        : ground_(domain)
        , size_(size)
        , at_(start.from)
        , direction_(start.direction)
        , is_first_(length(start.direction) > 0)
        , step_(initial * domain.longest * size) {
        way_.points.push_back(at_);
    }

    bool is_done() const { return is_done_; }
    DescentPath&& path() && { return std::move(way_); }
    const SpacePoint& tried() const { return tried_; }

    void here(const PointJet& jet) {
        if (!ground_.is_solid && ground_.is_outside(at_)) return end(DescentPath::End::outside);
        jet_ = within(jet, at_);
        aim();
    }
    void there(const PointJet& unbounded) {
        const PointJet jet = within(unbounded, tried_);
        if (!is_lower(jet)) {
            shorten();
            return;
        }
        at_ = tried_;
        way_.points.push_back(at_);
        if (!ground_.is_solid && ground_.is_outside(at_)) return end(DescentPath::End::outside);
        if (is_last_) return end(DescentPath::End::minimum);
        is_first_ = false;
        step_ = std::min(1.6 * step_, ground_.longest * size_);
        damping_ = 1;
        jet_ = jet;
        aim();
    }

private:
    void end(DescentPath::End how) {
        way_.end = how;
        is_done_ = true;
    }

    double inset() const { return 1e-7 * size_; } // of walls that a way keeps to

    // The jet as it is along the wall, where H falls out of the bounds.
    PointJet within(PointJet jet, const SpacePoint& p) const {
        if (!ground_.is_solid) return jet;
        if (const auto& sphere = ground_.sphere) return within_sphere(jet, p, *sphere);
        for (std::size_t i = 0; i < 3; ++i) {
            const formula::Interval wall = ground_.box[i];
            const bool is_free = jet.gradient[i] < 0 ? p[i] < wall.hi - 1.5 * inset()
                                                     : p[i] > wall.lo + 1.5 * inset();
            if (is_free) continue;
            jet.gradient[i] = 0;
            for (std::size_t j = 0; j < 3; ++j) jet.hessian[i][j] = jet.hessian[j][i] = i == j;
        }
        return jet;
    }

    PointJet within_sphere(PointJet jet, const SpacePoint& p, const Domain::Sphere& sphere) const {
        const SpacePoint off = difference(p, sphere.centre);
        const double far = length(off);
        const SpacePoint out = along({}, 1 / far, off);
        const double slope = dot(jet.gradient, out);
        if (slope >= 0 || far < sphere.radius - 1.5 * inset()) return jet;
        jet.gradient = along(jet.gradient, -slope, out);
        SpacePoint across;
        for (std::size_t i = 0; i < 3; ++i) across[i] = dot(jet.hessian[i], out);
        const double twice = dot(across, out);
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                jet.hessian[i][j] +=
                    (twice + 1) * out[i] * out[j] - across[i] * out[j] - out[i] * across[j];
            }
            // The sphere turns away.
            for (std::size_t j = 0; j < 3; ++j)
                jet.hessian[i][j] -= slope / far * (double(i == j) - out[i] * out[j]);
        }
        return jet;
    }

    // The nearest point inside of the walls.
    SpacePoint moved_inside(SpacePoint p) const {
        if (ground_.sphere) {
            const SpacePoint off = difference(p, ground_.sphere->centre);
            return along(ground_.sphere->centre, (ground_.sphere->radius - inset()) / length(off),
                         off);
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const formula::Interval wall = ground_.box[i];
            p[i] = std::clamp(p[i], wall.lo + inset(), wall.hi - inset());
        }
        return p;
    }

    bool is_lower(const PointJet& jet) const {
        if (!(jet.value < jet_.value)) return is_last_ && jet.value <= jet_.value + noise();
        if (is_newton_) return true;
        if (is_first_) return dot(jet.gradient, direction_) < 0;
        return inertia(jet.hessian).positive == 3 ||
               dot(jet.gradient, jet_.gradient) >
                   straight * length(jet.gradient) * length(jet_.gradient);
    }
    // A minimum's height is known to this.
    double noise() const { return 1e-12 * (1 + std::abs(jet_.value)); }

    void shorten() {
        if (is_last_) return end(DescentPath::End::minimum); // where it is
        step_ /= 2;
        damping_ /= 2;
        if (step_ < shortest * size_) return end(DescentPath::End::lost);
        aim();
    }

    // What to try next.
    void aim() {
        is_newton_ = is_last_ = false;
        SpacePoint by = along({}, step_, direction_);
        if (!is_first_) {
            const double steepness = length(jet_.gradient);
            if (steepness == 0) return end(DescentPath::End::minimum);
            by = along({}, -step_ / steepness, jet_.gradient);
            if (inertia(jet_.hessian).positive == 3) {
                if (const auto newton = solve(jet_.hessian, jet_.gradient)) {
                    const double far = length(*newton);
                    is_newton_ = true;
                    is_last_ = far <= at_rest * size_;
                    by = along({}, -damping_ * std::min(1.0, ground_.longest * size_ / far),
                               *newton);
                }
            }
        }
        tried_ = along(at_, 1, by);
        if (!ground_.is_solid || ground_.is_inside(tried_)) return;
        // A step that leaves the bounds goes on along a wall.
        tried_ = moved_inside(tried_);
        if (distance(tried_, at_) <= at_rest * size_) return end(DescentPath::End::minimum);
        if (!ground_.is_inside(tried_)) end(DescentPath::End::lost);
    }

    const Domain& ground_;
    double size_;
    SpacePoint at_, direction_, tried_{};
    PointJet jet_;
    bool is_first_, is_newton_ = false, is_last_ = false, is_done_ = false;
    double step_, damping_ = 1;
    DescentPath way_;
};

} // namespace

std::vector<DescentPath> descent_paths(PointField& field, const Domain& domain,
                                       std::span<const Start> starts) {
    const double size = longest_side(domain.box);
    std::vector<Walker> walkers;
    std::vector<SpacePoint> points;
    std::vector<PointJet> jets;
    for (const Start& start : starts) {
        walkers.emplace_back(domain, size, start);
        points.push_back(start.from);
    }
    field.jets(points, jets);
    for (std::size_t k = 0; k < walkers.size(); ++k) walkers[k].here(jets[k]);
    for (int step = 0; step < most_steps; ++step) {
        points.clear();
        for (const Walker& walker : walkers) {
            if (!walker.is_done()) points.push_back(walker.tried());
        }
        if (points.empty()) break;
        field.jets(points, jets);
        std::size_t next = 0;
        for (Walker& walker : walkers) {
            if (!walker.is_done()) walker.there(jets[next++]);
        }
    }
    std::vector<DescentPath> paths;
    paths.reserve(walkers.size());
    for (Walker& walker : walkers) paths.push_back(std::move(walker).path());
    return paths;
}

std::vector<SaddleConnection> saddle_connections(PointField& field, const Domain& domain,
                                                 std::span<const SpacePoint> saddles) {
    std::vector<PointJet> jets;
    field.jets(saddles, jets);
    std::vector<Start> over;
    for (std::size_t k = 0; k < saddles.size(); ++k)
        over.push_back({saddles[k], least_direction(jets[k].hessian)});
    return saddle_connections(field, domain, over);
}

std::vector<SaddleConnection> saddle_connections(PointField& field, const Domain& domain,
                                                 std::span<const Start> over) {
    std::vector<Start> starts;
    std::vector<SpacePoint> tops;
    for (const Start& start : over) {
        starts.push_back(start);
        starts.push_back({start.from, along({}, -1, start.direction)});
        tops.push_back(start.from);
    }
    std::vector<DescentPath> paths = descent_paths(field, domain, starts);
    std::vector<PointJet> jets;
    field.jets(tops, jets);
    std::vector<SaddleConnection> connections;
    for (std::size_t k = 0; k < over.size(); ++k)
        connections.push_back(
            {jets[k].value, {std::move(paths[2 * k]), std::move(paths[2 * k + 1])}});
    return connections;
}

} // namespace isomotion::topology
