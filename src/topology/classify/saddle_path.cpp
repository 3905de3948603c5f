#include "topology/classify/saddle_path.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "topology/classify/curvature.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

// The most that H can be on the segment from a to b, both ends' values and H's gradient along it
// known: it rises from either end at most as fast as that says, and so to where both bounds meet.
double most_between(Interval at_a, Interval at_b, Interval rise) {
    if (rise.hi <= 0) return at_a.hi;
    if (rise.lo >= 0) return at_b.hi;
    double meet = (at_b.hi - at_a.hi - rise.lo) / (rise.hi - rise.lo);
    if (!std::isfinite(meet)) return formula::infinity;
    meet = std::clamp(meet, 0.0, 1.0); // any place does
    const Interval from_a = Interval(at_a.hi) + Interval(meet) * Interval(rise.hi);
    const Interval from_b = Interval(at_b.hi) - (Interval(1) - Interval(meet)) * Interval(rise.lo);
    return std::max(from_a.hi, from_b.hi);
}

// H's derivative along the segment from a to b, from its own at the middle and that one's.
Interval rise_between(const SublevelSet& region, const SpacePoint& a, const SpacePoint& b) {
    SpaceBox middle, across;
    for (std::size_t i = 0; i < 3; ++i) {
        middle[i] = Interval(0.5) * (Interval(a[i]) + Interval(b[i]));
        across[i] = Interval(b[i]) - Interval(a[i]);
    }
    const SpaceHessian hessian = region.hessian(hull_of(point_box(a), point_box(b)));
    const auto gradient = region.over({&middle, 1}).front().gradient;
    Interval rise = 0;
    for (std::size_t i = 0; i < 3; ++i) rise = rise + gradient[i] * across[i];
    return rise + Interval(-0.5, 0.5) * curvature(hessian, across);
}

} // namespace

// Chords over many corners first; what is not proved of one is left to its halves, and between two
// neighbours to the halves of the segment.
bool is_path(const SublevelSet& region, std::span<const SpacePoint> corners, std::size_t* failed) {
    constexpr std::size_t most_pieces = 6000;
    if (corners.size() < 2) return false;
    const double shortest = 1e-11 * longest_side(region.box());
    struct Corner {
        SpacePoint at;
        std::size_t of; // position among the path's
        bool is_outside = false;
        Interval value{};
    };
    std::vector<Corner> known;
    for (std::size_t k = 0; k < corners.size(); ++k) known.push_back({corners[k], k});
    std::size_t valued = 0;
    // False if one is not in the region.
    const auto value_new = [&] {
        std::vector<SpaceBox> points;
        for (std::size_t k = valued; k < known.size(); ++k) {
            known[k].is_outside = region.is_outside(point_box(known[k].at));
            points.push_back(point_box(known[k].at));
        }
        const std::vector<Interval> values = region.values(points);
        for (std::size_t k = valued; k < known.size(); ++k) {
            Corner& corner = known[k];
            corner.value = values[k - valued];
            if (corner.is_outside) continue;
            if (corner.value.hi < 0 && region.may_hold(corner.at)) continue;
            if (failed) *failed = corner.of;
            return false;
        }
        valued = known.size();
        return true;
    };

    struct Chord {
        std::size_t a, b;
        bool is_segment; // of which no corner is known between its ends
    };
    constexpr std::size_t stride = 8;
    std::vector<Chord> open;
    for (std::size_t a = 0; a + 1 < corners.size(); a += stride) {
        const std::size_t b = std::min(a + stride, corners.size() - 1);
        open.push_back({a, b, b == a + 1});
    }
    std::size_t pieces = 0;
    while (!open.empty()) {
        if (!value_new()) return false;
        std::vector<Chord> asked, next;
        std::vector<SpaceBox> boxes;
        for (const Chord& chord : open) {
            const Corner &a = known[chord.a], &b = known[chord.b];
            // What is outside of convex bounds is connected.
            if (a.is_outside && b.is_outside) continue;
            const SpaceBox box = hull_of(point_box(a.at), point_box(b.at));
            if (region.is_outside(box)) continue;
            asked.push_back(chord);
            boxes.push_back(box);
        }
        pieces += boxes.size();
        const std::vector<ValueAndGradient> over = region.over(boxes);
        for (std::size_t k = 0; k < asked.size(); ++k) {
            const Chord& chord = asked[k];
            const Corner a = known[chord.a], b = known[chord.b];
            if (over[k].value.hi < 0) continue;
            Interval rise = 0;
            for (std::size_t i = 0; i < 3; ++i)
                rise = rise + over[k].gradient[i] * (Interval(b.at[i]) - Interval(a.at[i]));
            if (most_between(a.value, b.value, rise) < 0) continue;
            if (!chord.is_segment) {
                const std::size_t between = (chord.a + chord.b) / 2;
                next.push_back({chord.a, between, between == chord.a + 1});
                next.push_back({between, chord.b, chord.b == between + 1});
                continue;
            }
            rise = intersect(rise, rise_between(region, a.at, b.at));
            if (most_between(a.value, b.value, rise) < 0) continue;
            if (pieces > most_pieces || distance(a.at, b.at) < shortest) {
                if (failed) *failed = b.of;
                return false;
            }
            SpacePoint half;
            for (std::size_t i = 0; i < 3; ++i) half[i] = a.at[i] / 2 + b.at[i] / 2;
            next.push_back({chord.a, known.size(), true});
            next.push_back({known.size(), chord.b, true});
            known.push_back({half, b.of});
        }
        open = std::move(next);
    }
    return true;
}

} // namespace isomotion::topology
