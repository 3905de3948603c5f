#include "topology/classify/saddle_tracks.h"

#include <algorithm>

namespace isomotion::topology {
namespace {

// Parts of the box: how far a saddle is looked for from where it was; what a step is at a limit;
// and what two limits of one saddle differ by at most.
constexpr double reach = 0.03, at_rest = 1e-9, same = 1e-6;
constexpr int most_steps = 12;
constexpr int most_halvings = 3; // of the time between two events

bool is_saddle(const PointJet& jet) {
    const Inertia signs = inertia(jet.hessian);
    return signs.negative == 1 && signs.positive == 2;
}

struct Saddle {
    SpacePoint at;
    SpacePoint speed{};
    bool is_young = true; // its speed is not known
};

// Moves saddles from one time to another; those that are lost on the way are left out.
std::vector<Saddle> moved(const FieldAt& field, std::span<const Saddle> saddles, double from,
                          double to, double size, int halvings = 0) {
    std::vector<SpacePoint> guesses;
    const double dt = to - from;
    for (const Saddle& saddle : saddles) {
        const bool is_far = length(saddle.speed) * std::abs(dt) > reach * size;
        guesses.push_back(is_far ? saddle.at : along(saddle.at, dt, saddle.speed));
    }
    const auto found = saddles_near(field(to), guesses, size, reach * size);
    std::vector<Saddle> there, lost;
    for (std::size_t k = 0; k < saddles.size(); ++k) {
        const auto& at = found[k];
        if (!at) {
            lost.push_back(saddles[k]);
            continue;
        }
        const SpacePoint by = difference(*at, saddles[k].at);
        there.push_back({*at, along({}, 1 / dt, by), false});
    }
    if (!lost.empty() && halvings < most_halvings) {
        const double between = from / 2 + to / 2;
        const auto half = moved(field, lost, from, between, size, halvings + 1);
        const auto rest = moved(field, half, between, to, size, halvings + 1);
        there.insert(there.end(), rest.begin(), rest.end());
    }
    return there;
}

void leave_one_of_each(std::vector<Saddle>& saddles, double apart) {
    std::vector<Saddle> once;
    for (const Saddle& saddle : saddles) {
        const auto is_it = [&](const Saddle& other) {
            return distance(other.at, saddle.at) <= apart;
        };
        if (std::ranges::none_of(once, is_it)) once.push_back(saddle);
    }
    saddles = std::move(once);
}

} // namespace

std::vector<std::optional<SpacePoint>>
saddles_near(PointField& field, std::span<const SpacePoint> points, double size, double most) {
    std::vector<std::optional<SpacePoint>> found(points.size());
    std::vector<SpacePoint> on(points.begin(), points.end()), first = on;
    std::vector<std::size_t> which(points.size());
    for (std::size_t k = 0; k < which.size(); ++k) which[k] = k;
    std::vector<PointJet> jets;
    for (int step = 0; step < most_steps && !on.empty(); ++step) {
        field.jets(on, jets);
        std::size_t kept = 0;
        for (std::size_t k = 0; k < on.size(); ++k) {
            const auto by = solve(jets[k].hessian, jets[k].gradient);
            if (!by) continue;
            const SpacePoint next = difference(on[k], *by);
            const SpacePoint begun = first[k];
            if (!(distance(next, begun) <= most)) continue;
            if (length(*by) <= at_rest * size) {
                if (jets[k].value < 0 && is_saddle(jets[k])) found[which[k]] = next;
                continue;
            }
            on[kept] = next;
            first[kept] = begun;
            which[kept] = which[k];
            ++kept;
        }
        on.resize(kept);
        first.resize(kept);
        which.resize(kept);
    }
    return found;
}

void add_points(std::vector<SpacePoint>& points, std::span<const SpacePoint> more, double apart) {
    for (const SpacePoint& p : more) {
        const auto is_it = [&](const SpacePoint& other) { return distance(other, p) <= apart; };
        if (std::ranges::none_of(points, is_it)) points.push_back(p);
    }
}

std::vector<std::vector<SpacePoint>> saddles_at_events(const FieldAt& field,
                                                       std::span<const Event> events, int index,
                                                       const SpaceBox& box,
                                                       const std::function<bool()>& stopped) {
    const double size = longest_side(box);
    std::vector<std::vector<SpacePoint>> found(events.size());
    std::vector<std::size_t> which;
    for (std::size_t k = 0; k < events.size(); ++k) {
        if (events[k].index == index && events[k].stratum == 3) which.push_back(k);
    }
    for (const bool is_forwards : {true, false}) {
        std::vector<Saddle> saddles;
        double time = 0;
        for (const std::size_t k : which) {
            if (stopped && stopped()) return found;
            const double now = mid(events[k].time);
            if (!saddles.empty() && now != time) saddles = moved(field, saddles, time, now, size);
            leave_one_of_each(saddles, same * size);
            time = now;
            std::vector<SpacePoint> points;
            points.reserve(saddles.size());
            for (const Saddle& saddle : saddles) points.push_back(saddle.at);
            add_points(found[k], points, same * size);
            saddles.push_back({middle(events[k].where)});
        }
        if (is_forwards) std::ranges::reverse(which);
    }
    return found;
}

std::vector<SpacePoint> saddles_from_seeds(PointField& field, const SpaceBox& box, int seeds) {
    // Multiples of the powers of 1/g modulo 1, g^4 = g + 1: the golden ratio's sequence in space.
    constexpr double g = 1.2207440846057595;
    const double size = longest_side(box);
    std::vector<SpacePoint> from, found;
    for (int k = 1; k <= seeds; ++k) {
        SpacePoint p;
        double power = 1;
        for (std::size_t i = 0; i < 3; ++i) {
            power /= g;
            const double at = 0.5 + power * k;
            p[i] = box[i].lo + (at - std::floor(at)) * (box[i].hi - box[i].lo);
        }
        from.push_back(p);
    }
    for (const auto& limit : saddles_near(field, from, size, size / 4)) {
        if (limit) add_points(found, {&*limit, 1}, same * size);
    }
    return found;
}

} // namespace isomotion::topology
