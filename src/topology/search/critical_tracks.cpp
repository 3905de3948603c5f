#include "topology/search/critical_tracks.h"

#include <algorithm>
#include <cmath>

#include "base/workers.h"
#include "topology/search/krawczyk.h"
#include "topology/search/seeds.h"

namespace isomotion::topology {
namespace {

constexpr std::size_t points_together = 64; // points
constexpr int most_steps = 25, most_steps_on = 8;
// From this step on each is shorter than the one before by this factor, or leads nowhere.
constexpr int first_sure_step = 3;
constexpr double surely = 0.9;
constexpr std::size_t most_points = 4096; // followed at a moment
// Parts of the domain: what a step is at a limit; what two limits of one point differ by at most;
// how far outside a limit may lie, and how far from where it was sought.
constexpr double at_rest = 1e-7, same = 1e-6, outside = 0.02, reach = 0.1;
// Points of curves of critical points are none: there is no end to them.
constexpr double most_stretched = 1e9;

struct Critical {
    Point at{};
    Point speed{}; // by clock
    double value = 0;
    std::size_t before = none, after = none; // the same one at the moments around
    static constexpr std::size_t none = std::size_t(-1);
};
using Moment = std::vector<Critical>;

class Follower {
public:
    Follower(const MovingField& field, const TrackOptions& how, std::int64_t& evaluations)
        : field_(field)
        , how_(how)
        , evaluations_(evaluations)
        , d_(std::size_t(field.dimension())) {
        for (std::size_t k = 0; k <= d_; ++k) {
            const double whole = field.domain()[k].hi - field.domain()[k].lo;
            side_[k] = whole > 0 ? whole : 1;
        }
    }

    // Limits of Newton's method in space, from these points at their clocks; in order, `none` for
    // those that are lost.
    std::vector<std::optional<Critical>> limits(std::span<const Point> from, int steps) {
        std::vector<std::optional<Critical>> found(from.size());
        const std::size_t batches = (from.size() + points_together - 1) / points_together;
        std::vector<std::int64_t> evaluations(batches, 0);
        base::share(base::SharedLoop{batches, how_.threads, how_.stopped, {}}, [&] {
            return [&, numbers = Numbers(field_)](std::size_t k) mutable {
                const auto batch =
                    from.subspan(k * points_together,
                                 std::min(points_together, from.size() - k * points_together));
                follow(numbers, batch, steps,
                       std::span(found).subspan(k * points_together, batch.size()), evaluations[k]);
            };
        });
        for (const std::int64_t number : evaluations) evaluations_ += number;
        return found;
    }

    bool is_same(const Point& a, const Point& b) const {
        for (std::size_t i = 0; i < d_; ++i) {
            if (!(std::abs(a[i] - b[i]) <= same * side_[i])) return false;
        }
        return true;
    }

    // Its place among the moment's, of which it becomes one if it isn't yet.
    std::size_t place(Moment& moment, const Critical& point) const {
        for (std::size_t k = 0; k < moment.size(); ++k) {
            if (is_same(moment[k].at, point.at)) return k;
        }
        if (moment.size() >= most_points) return Critical::none;
        moment.push_back(point);
        return moment.size() - 1;
    }

    Point guess(const Critical& point, double clock) const {
        Point at = point.at;
        const double by = clock - at[d_];
        for (std::size_t i = 0; i < d_; ++i) at[i] += by * point.speed[i];
        at[d_] = clock;
        return at;
    }

private:
    void follow(Numbers& numbers, std::span<const Point> from, int steps,
                std::span<std::optional<Critical>> found, std::int64_t& evaluations) const {
        std::vector<Point> on(from.begin(), from.end());
        std::vector<std::size_t> which(from.size());
        for (std::size_t k = 0; k < which.size(); ++k) which[k] = k;
        std::vector<double> last(from.size(), 1);
        std::vector<Jet<double>> jets;
        for (int step = 0; step < steps && !on.empty(); ++step) {
            numbers.jets(on, jets);
            evaluations += std::int64_t(on.size());
            std::size_t kept = 0;
            for (std::size_t k = 0; k < on.size(); ++k) {
                const std::size_t from_which = which[k];
                Critical point{on[k], {}, jets[k].value};
                const auto moved = newton(jets[k], point);
                if (!moved) continue;
                if (*moved <= at_rest) {
                    found[from_which] = point;
                    continue;
                }
                if (!is_near(point.at, from[from_which])) continue;
                if (step >= first_sure_step && *moved > surely * last[from_which]) continue;
                last[from_which] = *moved;
                on[kept] = point.at;
                which[kept++] = from_which;
            }
            on.resize(kept);
            which.resize(kept);
        }
    }

    // Takes a step; how long it is as a part of the domain. Empty where there is none.
    std::optional<double> newton(const Jet<double>& jet, Critical& point) const {
        const auto y = inverse(jet.hessian, int(d_));
        if (!y) return std::nullopt;
        double moved = 0, stretch = 0, shrink = 0;
        for (std::size_t i = 0; i < d_; ++i) {
            double step = 0, speed = 0;
            for (std::size_t j = 0; j < d_; ++j) {
                step += (*y)[i][j] * jet.gradient[j];
                speed -= (*y)[i][j] * jet.hessian[j][d_];
                stretch = std::max(stretch, std::abs(jet.hessian[i][j]));
                shrink = std::max(shrink, std::abs((*y)[i][j]));
            }
            point.at[i] -= step;
            point.speed[i] = speed;
            moved = std::max(moved, std::abs(step) / side_[i]);
        }
        if (!(stretch * shrink <= most_stretched)) return std::nullopt;
        return moved;
    }

    bool is_near(const Point& at, const Point& from) const {
        for (std::size_t i = 0; i < d_; ++i) {
            const formula::Interval domain = field_.domain()[i];
            if (!(std::abs(at[i] - from[i]) <= reach * side_[i])) return false;
            if (!(at[i] >= domain.lo - outside * side_[i])) return false;
            if (!(at[i] <= domain.hi + outside * side_[i])) return false;
        }
        return true;
    }

    const MovingField& field_;
    const TrackOptions& how_;
    std::int64_t& evaluations_;
    std::size_t d_;
    Point side_{};
};

} // namespace

std::vector<Point> near_crossings(const MovingField& field, const TrackOptions& how,
                                  std::int64_t& evaluations) {
    const auto d = std::size_t(field.dimension());
    const formula::Interval clocks = field.domain()[d];
    constexpr std::size_t count = 64;
    const auto clock = [&](std::size_t k) {
        return clocks.lo + (clocks.hi - clocks.lo) * double(k) / double(count - 1);
    };
    Follower follower(field, how, evaluations);
    const Seeds seeds(field);
    std::vector<Moment> moments(count);
    std::vector<Point> from;
    std::vector<std::size_t> of;
    for (int number = 0; number < how.seeds; ++number) {
        Point p = seeds[number];
        const double part = (p[d] - clocks.lo) / (clocks.hi - clocks.lo);
        of.push_back(
            std::size_t(std::clamp(std::lround(part * double(count - 1)), 0L, long(count) - 1)));
        p[d] = clock(of.back());
        from.push_back(p);
    }
    const auto limits = follower.limits(from, most_steps);
    for (std::size_t k = 0; k < limits.size(); ++k) {
        const auto& limit = limits[k];
        if (limit) follower.place(moments[of[k]], *limit);
    }
    const auto follow_on = [&](std::size_t k, std::size_t next, bool forwards) {
        std::vector<Point> guesses;
        std::vector<std::size_t> which;
        for (std::size_t c = 0; c < moments[k].size(); ++c) {
            const Critical& point = moments[k][c];
            if ((forwards ? point.after : point.before) != Critical::none) continue;
            guesses.push_back(follower.guess(point, clock(next)));
            which.push_back(c);
        }
        const auto there = follower.limits(guesses, most_steps_on);
        for (std::size_t c = 0; c < there.size(); ++c) {
            if (!there[c]) continue;
            const std::size_t place = follower.place(moments[next], *there[c]);
            if (place == Critical::none) continue;
            Critical &here = moments[k][which[c]], &other = moments[next][place];
            (forwards ? here.after : here.before) = place;
            (forwards ? other.before : other.after) = which[c];
        }
    };
    const auto is_stopped = [&] { return how.stopped && how.stopped(); };
    for (std::size_t k = 0; k + 1 < count && !is_stopped(); ++k) {
        follow_on(k, k + 1, true);
        if (how.progress) how.progress(0.5 + 0.25 * double(k + 1) / double(count));
    }
    for (std::size_t k = count - 1; k > 0 && !is_stopped(); --k) {
        follow_on(k, k - 1, false);
        if (how.progress) how.progress(1 - 0.25 * double(k) / double(count));
    }
    std::vector<Point> near;
    for (std::size_t k = 0; k < count; ++k) {
        for (const Critical& point : moments[k]) {
            const auto at = [&](std::size_t moment, std::size_t which) {
                return which == Critical::none ? nullptr : &moments[moment][which];
            };
            const Critical* before = k > 0 ? at(k - 1, point.before) : nullptr;
            const Critical* after = k + 1 < count ? at(k + 1, point.after) : nullptr;
            if (after && (after->value > 0) != (point.value > 0)) {
                const double part = point.value / (point.value - after->value);
                Point p{};
                for (std::size_t i = 0; i <= d; ++i)
                    p[i] = point.at[i] + part * (after->at[i] - point.at[i]);
                near.push_back(p);
            }
            // Between moments it may pass 0 twice; at a track's ends, it may be about to.
            const auto is_farther = [&](const Critical* other) {
                return !other || ((other->value > 0) == (point.value > 0) &&
                                  std::abs(other->value) >= std::abs(point.value));
            };
            if (is_farther(before) && is_farther(after)) near.push_back(point.at);
        }
    }
    return near;
}

} // namespace isomotion::topology
