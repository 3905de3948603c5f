#include "topology/search/seeded.h"

#include <algorithm>
#include <cmath>

#include "base/workers.h"
#include "topology/search/critical_system.h"
#include "topology/search/critical_tracks.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

// Newton's method is there sooner if it begins close by.
constexpr int most_steps = 25;
// Parts of the domain: how far outside of it a newton to a root may lead; what a step is at a
// limit; what two limits of one root differ by at most; and half the side of the box of its proof.
constexpr double outside = 0.1, at_rest = 1e-11, same = 1e-8, tiny = 1e-9;
// Limits without a proof are put together over this part of the domain: of a degenerate point there
// are many, all about it.
constexpr double blurred = 1e-2;

double side(const MovingField& field, std::size_t k) {
    const double whole = field.domain()[k].hi - field.domain()[k].lo;
    return whole > 0 ? whole : 1;
}

int seeds_of(const MovingField& field, int seeds) {
    const double part = field.variables() / 4.0; // of place and time
    return std::max(8, int(std::lround(std::pow(seeds, part))));
}

enum class Newton { on, lost, there };

Newton follow(const MovingField& field, const Jet<double>& jet, Point& x) {
    const auto n = std::size_t(field.variables());
    const auto step = newton_step(jet, n);
    if (!step) return Newton::lost;
    double moved = 0;
    for (std::size_t k = 0; k < n; ++k) {
        x[k] -= (*step)[k];
        const double whole = side(field, k);
        const Interval domain = field.domain()[k];
        if (!(x[k] >= domain.lo - outside * whole && x[k] <= domain.hi + outside * whole)) {
            return Newton::lost;
        }
        moved = std::max(moved, std::abs((*step)[k]) / whole);
    }
    return moved <= at_rest ? Newton::there : Newton::on;
}

bool is_inside(const MovingField& field, const Point& x) {
    for (std::size_t k = 0; k < std::size_t(field.variables()); ++k) {
        const double by = tiny * side(field, k);
        const Interval domain = field.domain()[k];
        if (!(x[k] >= domain.lo - by && x[k] <= domain.hi + by)) return false;
    }
    return true;
}

// Limits in the domain.
std::vector<Point> limits(const MovingField& field, std::span<const Point> from,
                          std::int64_t& evaluations) {
    Numbers numbers(field);
    std::vector<Point> on(from.begin(), from.end()), found;
    std::vector<Jet<double>> jets;
    for (int k = 0; k < most_steps && !on.empty(); ++k) {
        numbers.jets(on, jets);
        evaluations += std::int64_t(on.size());
        std::size_t kept = 0;
        for (std::size_t p = 0; p < on.size(); ++p) {
            Point x = on[p];
            const Newton newton = follow(field, jets[p], x);
            if (newton == Newton::on) on[kept++] = x;
            if (newton == Newton::there && is_inside(field, x)) found.push_back(x);
        }
        on.resize(kept);
    }
    return found;
}

// Each limit once, by clock.
std::vector<Point> distinct(const MovingField& field, std::vector<Point> limits) {
    const auto n = std::size_t(field.variables()), clock = n - 1;
    std::sort(limits.begin(), limits.end(), [&](const Point& a, const Point& b) {
        return std::tie(a[clock], a) < std::tie(b[clock], b);
    });
    std::vector<Point> once;
    std::size_t near = 0; // the first that may be the same by its clock
    for (const Point& x : limits) {
        while (near < once.size() && x[clock] - once[near][clock] > same * side(field, clock)) {
            ++near;
        }
        const auto is_x = [&](const Point& other) {
            for (std::size_t k = 0; k < n; ++k) {
                if (!(std::abs(x[k] - other[k]) <= same * side(field, k))) return false;
            }
            return true;
        };
        if (std::none_of(once.begin() + std::ptrdiff_t(near), once.end(), is_x)) once.push_back(x);
    }
    return once;
}

Box about(const MovingField& field, const Point& x) {
    Box box{};
    for (std::size_t k = 0; k < std::size_t(field.variables()); ++k) {
        const double by = tiny * side(field, k);
        box[k] = {x[k] - by, x[k] + by};
    }
    return box;
}

} // namespace

SearchResult from_seeds(const MovingField& field, const SeedOptions& seeding) {
    SearchResult found;
    TrackOptions tracking{.seeds = seeds_of(field, seeding.seeds),
                          .threads = seeding.threads,
                          .stopped = seeding.stopped,
                          .progress = {}};
    base::SharedLoop proving{
        .threads = seeding.threads, .stopped = seeding.stopped, .progress = {}};
    if (seeding.progress) {
        constexpr double tracks = 0.8;
        tracking.progress = [&](double part) { seeding.progress(tracks * part); };
        proving.progress = [&](double part) { seeding.progress(tracks + (1 - tracks) * part); };
    }
    const std::vector<Point> near = near_crossings(field, tracking, found.work.boxes);
    const std::vector<Point> once = distinct(field, limits(field, near, found.work.boxes));
    proving.count = once.size();
    std::vector<std::optional<CriticalPoint>> points(once.size());
    const auto prove = [&] {
        return
            [&, enclosures = Enclosures(field), numbers = Numbers(field)](std::size_t k) mutable {
                points[k] = isolate(field, enclosures, numbers, about(field, once[k]));
            };
    };
    base::share(proving, prove);
    for (std::size_t k = 0; k < once.size(); ++k) {
        const auto& point = points[k];
        if (point) {
            found.points.push_back(*point);
        } else {
            found.unresolved.push_back(about(field, once[k]));
        }
    }
    put_together(found);
    found.unresolved = merged(std::move(found.unresolved), field.domain(), blurred);
    return found;
}

} // namespace isomotion::topology
