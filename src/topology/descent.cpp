#include "topology/descent.h"

#include <algorithm>
#include <numeric>
#include <ranges>

namespace isomotion::topology {
namespace {

// Parts of the box: the longest step, the first one, what Newton's step is at a minimum, and where
// a step gives up.
constexpr double longest = 0.03, initial = 0.004, at_rest = 1e-7, shortest = 1e-9;
constexpr int most_steps = 300;
// From one step to the next the slope turns by less than the angle of this cosine.
constexpr double straight = 0.3;

// One way, a step at a time: the point that it tries, and what it makes of the field there.
class Walker {
public:
    Walker(const Ground& ground, double size, const Start& start)
        : ground_(ground)
        , size_(size)
        , at_(start.from)
        , direction_(start.direction)
        , is_first_(length(start.direction) > 0)
        , step_(initial * size) {
        way_.points.push_back(at_);
    }

    bool is_done() const { return is_done_; }
    Way&& way() && { return std::move(way_); }
    const SpacePoint& tried() const { return tried_; }

    void here(const PointJet& jet) {
        jet_ = jet;
        aim();
    }
    void there(const PointJet& jet) {
        if (!is_lower(jet)) {
            shorten();
            return;
        }
        at_ = tried_;
        way_.points.push_back(at_);
        if (!ground_.is_solid && ground_.is_outside(at_)) return end(Way::End::outside);
        if (is_last_) return end(Way::End::minimum);
        is_first_ = false;
        step_ = std::min(1.6 * step_, longest * size_);
        damping_ = 1;
        jet_ = jet;
        aim();
    }

private:
    void end(Way::End how) {
        way_.end = how;
        is_done_ = true;
    }

    bool is_lower(const PointJet& jet) const {
        if (!(jet.value < jet_.value)) return is_last_ && jet.value <= jet_.value + noise();
        if (is_newton_) return true;
        if (is_first_) return dot(jet.slope, direction_) < 0;
        return inertia(jet.bend).positive == 3 ||
               dot(jet.slope, jet_.slope) > straight * length(jet.slope) * length(jet_.slope);
    }
    // A minimum's height is known to this.
    double noise() const { return 1e-12 * (1 + std::abs(jet_.value)); }

    void shorten() {
        if (is_last_) return end(Way::End::minimum); // where it is
        step_ /= 2;
        damping_ /= 2;
        if (step_ < shortest * size_) return end(Way::End::lost);
        aim();
    }

    // What to try next.
    void aim() {
        is_newton_ = is_last_ = false;
        SpacePoint by = along({}, step_, direction_);
        if (!is_first_) {
            const double steepness = length(jet_.slope);
            if (steepness == 0) return end(Way::End::minimum);
            by = along({}, -step_ / steepness, jet_.slope);
            if (inertia(jet_.bend).positive == 3) {
                if (const auto newton = solve(jet_.bend, jet_.slope)) {
                    const double far = length(*newton);
                    is_newton_ = true;
                    is_last_ = far <= at_rest * size_;
                    by = along({}, -damping_ * std::min(1.0, longest * size_ / far), *newton);
                }
            }
        }
        tried_ = along(at_, 1, by);
        if (!ground_.is_solid || ground_.is_inside(tried_)) return;
        // Along a wall.
        for (std::size_t i = 0; i < 3; ++i) {
            const formula::Interval wall = ground_.box[i];
            const double inset = 1e-7 * size_;
            tried_[i] = std::clamp(tried_[i], wall.lo + inset, wall.hi - inset);
        }
        if (distance(tried_, at_) <= at_rest * size_) return end(Way::End::minimum);
        if (!ground_.is_inside(tried_)) end(Way::End::lost);
    }

    const Ground& ground_;
    double size_;
    SpacePoint at_, direction_, tried_{};
    PointJet jet_;
    bool is_first_, is_newton_ = false, is_last_ = false, is_done_ = false;
    double step_, damping_ = 1;
    Way way_;
};

} // namespace

std::vector<Way> ways_down(PointField& field, const Ground& ground, std::span<const Start> starts) {
    const double size = longest_side(ground.box);
    std::vector<Walker> walkers;
    std::vector<SpacePoint> points;
    std::vector<PointJet> jets;
    for (const Start& start : starts) {
        walkers.emplace_back(ground, size, start);
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
    std::vector<Way> ways;
    for (Walker& walker : walkers) ways.push_back(std::move(walker).way());
    return ways;
}

std::vector<Pass> passes(PointField& field, const Ground& ground,
                         std::span<const SpacePoint> saddles) {
    std::vector<PointJet> jets;
    field.jets(saddles, jets);
    std::vector<Start> starts;
    for (std::size_t k = 0; k < saddles.size(); ++k) {
        const SpacePoint direction = least_direction(jets[k].bend);
        for (const double sign : {1.0, -1.0})
            starts.push_back({saddles[k], along({}, sign, direction)});
    }
    std::vector<Way> ways = ways_down(field, ground, starts);
    std::vector<Pass> passes;
    for (std::size_t k = 0; k < saddles.size(); ++k) {
        passes.push_back({jets[k].value, {std::move(ways[2 * k]), std::move(ways[2 * k + 1])}});
    }
    return passes;
}

PassGraph::PassGraph(std::span<const Pass> passes, double same)
    : passes_(passes)
    , same_(same)
    , by_height_(passes.size()) {
    for (const Pass& pass : passes) ends_.push_back({node(pass.ways[0]), node(pass.ways[1])});
    std::iota(by_height_.begin(), by_height_.end(), std::size_t(0));
    std::ranges::stable_sort(by_height_, {}, [&](std::size_t k) { return passes[k].height; });
}

// Node 0 is all that is outside of the bounds.
int PassGraph::node(const Way& way) {
    if (way.end == Way::End::outside) return 0;
    const SpacePoint& end = way.points.back();
    for (std::size_t k = 0; k < minima_.size(); ++k) {
        if (way.end == Way::End::minimum && distance(minima_[k], end) <= same_) return int(k) + 1;
    }
    minima_.push_back(end);
    return int(minima_.size());
}

std::optional<Route> PassGraph::route(const Way& from, const Way& to,
                                      const std::vector<bool>& is_closed) {
    if (from.end == Way::End::lost || to.end == Way::End::lost) return std::nullopt;
    const int first = node(from), last = node(to);
    // Kruskal's tree of the lowest passes, until it joins both.
    std::vector<int> part(minima_.size() + 1);
    std::iota(part.begin(), part.end(), 0);
    const auto part_of = [&](int k) {
        while (part[std::size_t(k)] != k)
            k = part[std::size_t(k)] = part[std::size_t(part[std::size_t(k)])];
        return k;
    };
    std::vector<std::vector<std::size_t>> tree(part.size()); // passes at each minimum
    for (const std::size_t k : by_height_) {
        if (part_of(first) == part_of(last)) break;
        const auto [a, b] = ends_[k];
        if (is_closed[k] || part_of(a) == part_of(b)) continue;
        part[std::size_t(part_of(a))] = part_of(b);
        tree[std::size_t(a)].push_back(k);
        tree[std::size_t(b)].push_back(k);
    }
    if (part_of(first) != part_of(last)) return std::nullopt;
    // Back from the last one, each minimum knows by which pass it was come to.
    std::vector<std::optional<std::size_t>> by(part.size());
    std::vector<int> reached{last};
    const auto other = [&](std::size_t k, int end) { return ends_[k][ends_[k][0] == end]; };
    for (std::size_t next = 0; next < reached.size(); ++next) {
        const int here = reached[next];
        for (const std::size_t k : tree[std::size_t(here)]) {
            const int there = other(k, here);
            if (there == last || by[std::size_t(there)]) continue;
            by[std::size_t(there)] = k;
            reached.push_back(there);
        }
    }
    Route route;
    const auto add = [&](const auto& points, std::size_t over) {
        route.points.insert(route.points.end(), points.begin(), points.end());
        route.over.resize(route.points.size(), over);
    };
    add(from.points, Route::none);
    for (int here = first; here != last;) {
        const std::size_t k = *by[std::size_t(here)];
        const std::size_t up = ends_[k][0] == here ? 0 : 1;
        add(std::views::reverse(passes_[k].ways[up].points), k);
        add(std::views::drop(passes_[k].ways[1 - up].points, 1), k);
        here = ends_[k][1 - up];
    }
    add(std::views::reverse(to.points), Route::none);
    return route;
}

} // namespace isomotion::topology
