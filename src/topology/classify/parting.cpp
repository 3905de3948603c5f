#include "topology/classify/parting.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <unordered_map>
#include <utility>

#include "topology/classify/parting_plane.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

constexpr int deepest = 18; // halvings of each side of the bounds

// Halved 2^level times along each axis.
struct BoxKey {
    int level = 0;
    std::array<int, 3> at{};

    std::uint64_t packed() const {
        std::uint64_t bits = std::uint64_t(level);
        for (const int k : at) bits = bits << 19 | std::uint64_t(k);
        return bits;
    }
    BoxKey above() const { return {level - 1, {at[0] >> 1, at[1] >> 1, at[2] >> 1}}; }
    BoxKey part(int number) const {
        BoxKey part{level + 1, {}};
        for (std::size_t k = 0; k < 3; ++k) part.at[k] = 2 * at[k] + (number >> k & 1);
        return part;
    }
};

class Boxes {
public:
    Boxes(const SublevelSet& region, const PartingPlane& plane, const PartingOptions& how)
        : region_(region)
        , plane_(plane)
        , how_(how) {
        const BoxKey whole;
        add({&whole, 1});
    }

    Sides sides(const std::array<SpacePoint, 2>& starts) {
        const auto is_known = [&](const SpacePoint& start) {
            return region_.is_inside(start) || region_.is_outside(point_box(start));
        };
        if (!is_known(starts[0]) || !is_known(starts[1])) return Sides::unknown;
        while (boxes_.size() < how_.boxes && !(how_.stopped && how_.stopped())) {
            const auto way = way_between(starts);
            if (!way) return Sides::apart;
            std::vector<std::size_t> open;
            for (std::size_t k = 0; k < way->size(); ++k) {
                const Half now = (*way)[k];
                if (now == outside) continue;
                const One& one = boxes_[box_of(now)];
                const bool is_beside_outside = (k > 0 && (*way)[k - 1] == outside) ||
                                               (k + 1 < way->size() && (*way)[k + 1] == outside);
                if (one.state == State::open || (is_beside_outside && !one.leaves))
                    open.push_back(box_of(now));
            }
            if (open.empty()) return Sides::joined;
            // The largest first: those beside them may not be needed then.
            int least = deepest;
            for (const std::size_t box : open) least = std::min(least, boxes_[box].key.level);
            if (least >= deepest) return Sides::unknown;
            std::erase_if(open, [&](std::size_t box) {
                const int level = boxes_[box].key.level;
                return level > least + 1 || level >= deepest;
            });
            divide(open);
        }
        return Sides::unknown;
    }

private:
    enum class State : char { open, in, out }; // of the region
    struct One {
        BoxKey key;
        SpaceBox where;
        State state = State::open;
        bool is_divided = false;
        bool is_parted = false; // in W, on both sides of the plane: of two halves
        bool may_leave = false; // may have a point outside of the bounds,
        bool leaves = false;    // or does have one on it
    };
    // A box, or the half of one on a side of the plane; `outside` is all that is outside of the
    // bounds.
    using Half = std::size_t;
    static constexpr Half outside = 0;
    static Half half(std::size_t box, bool is_upper) { return 1 + 2 * box + std::size_t(is_upper); }
    static std::size_t box_of(Half h) { return (h - 1) / 2; }
    static bool is_upper(Half h) { return (h - 1) % 2 == 1; }

    SpaceBox where(const BoxKey& key) const {
        SpaceBox box;
        for (std::size_t k = 0; k < 3; ++k) {
            const Interval whole = region_.box()[k];
            const auto place = [&](int at) {
                return at == 1 << key.level
                           ? whole.hi
                           : whole.lo + (whole.hi - whole.lo) * (double(at) / (1 << key.level));
            };
            box[k] = {place(key.at[k]), place(key.at[k] + 1)};
        }
        return box;
    }

    // The box of the bounds holds all of them.
    static bool reaches_end(const BoxKey& key) {
        return std::ranges::any_of(key.at,
                                   [&](int at) { return at == 0 || at + 1 == 1 << key.level; });
    }

    // Adds boxes, each judged: one that is not judged leads nowhere, and would seem to separate the
    // sides. All at once, since evaluating many boxes together costs less than one after the other.
    void add(std::span<const BoxKey> keys) {
        std::vector<SpaceBox> boxes, middles;
        for (const BoxKey& key : keys) {
            boxes.push_back(where(key));
            middles.push_back(point_box(middle(boxes.back())));
        }
        const std::vector<Interval> values = narrow_values(keys, boxes, middles);
        for (std::size_t k = 0; k < boxes.size(); ++k) {
            numbers_.emplace(keys[k].packed(), boxes_.size());
            const One one = judged(keys[k], boxes[k], values[k]);
            boxes_.push_back(one);
            marks_.push_back({one.state == State::in, one.is_parted});
            about_.emplace_back();
        }
    }

    void divide(const std::vector<std::size_t>& numbers) {
        for (const std::size_t number : numbers) {
            for (const std::size_t other : about(number)) about_[other].reset();
            about_[number].reset();
        }
        std::vector<BoxKey> keys;
        for (const std::size_t number : numbers) {
            // A way may hold both halves of a parted box.
            if (std::exchange(boxes_[number].is_divided, true)) continue;
            for (int k = 0; k < 8; ++k) keys.push_back(boxes_[number].key.part(k));
        }
        add(keys);
    }

    // Encloses H over boxes, those better whose sign is not known at once: by its gradient, then by
    // its second derivatives.
    std::vector<Interval> narrow_values(std::span<const BoxKey> keys,
                                        std::span<const SpaceBox> boxes,
                                        std::span<const SpaceBox> middles) {
        std::vector<ValueAndGradient> over = region_.over(boxes), of_some;
        std::vector<std::size_t> which;
        std::vector<SpaceBox> some;
        const auto choose = [&](std::span<const SpaceBox> from, auto&& is_chosen) {
            which.clear();
            some.clear();
            for (std::size_t k = 0; k < boxes.size(); ++k) {
                if (!contains(over[k].value, 0.0) || !is_chosen(keys[k].level)) continue;
                which.push_back(k);
                some.push_back(from[k]);
            }
        };
        choose(middles, [](int) { return true; });
        const std::vector<Interval> at_middles = region_.values(some);
        for (std::size_t s = 0; s < which.size(); ++s) {
            const std::size_t k = which[s];
            Interval value = at_middles[s];
            for (std::size_t i = 0; i < 3; ++i)
                value = value + over[k].gradient[i] * (boxes[k][i] - middles[k][i]);
            over[k].value = intersect(over[k].value, value);
        }
        choose(boxes, [&](int level) { return is_worth_tightening(level); });
        for (const std::size_t k : which) of_some.push_back(over[k]);
        region_.tighten(some, of_some);
        for (std::size_t s = 0; s < which.size(); ++s) {
            over[which[s]].value = of_some[s].value;
            Tightened& tightened = tightened_[std::size_t(keys[which[s]].level)];
            ++tightened.tried;
            tightened.ended += !contains(of_some[s].value, 0.0);
        }
        std::vector<Interval> values;
        values.reserve(over.size());
        for (const ValueAndGradient& one : over) values.push_back(one.value);
        return values;
    }

    // Second derivatives tell the sign of small boxes, and cost more than they save where they
    // don't: what they did for boxes of the same size decides, and every sixteenth is tried.
    bool is_worth_tightening(int level) {
        constexpr int tried_to_judge = 16, one_of = 16;
        constexpr double worth = 0.05;
        Tightened& tightened = tightened_[std::size_t(level)];
        return tightened.tried < tried_to_judge || tightened.ended >= worth * tightened.tried ||
               ++tightened.skipped % one_of == 0;
    }

    // By an enclosure of H over the box.
    One judged(const BoxKey& key, const SpaceBox& where, const Interval& value) const {
        One one{.key = key, .where = where};
        one.state = value.hi < 0 ? State::in : value.lo > 0 ? State::out : State::open;
        // A solid ends at the bounds; what is beyond them is the outside.
        if (region_.is_all_outside(one.where)) one.state = State::out;
        const bool is_all_inside = region_.is_all_inside(one.where);
        const bool is_around = plane_.is_around(one.where);
        if (region_.is_solid()) {
            if (one.state == State::in && !is_all_inside) one.state = State::open;
        } else {
            one.may_leave = !is_all_inside && !(plane_.is_wall && is_around);
            one.leaves = reaches_end(one.key) || region_.has_corner_outside(one.where);
        }
        one.is_parted = !plane_.is_wall && is_around && plane_.side(one.where) == 0;
        return one;
    }

    // The undivided boxes beside those of one, kept until one of them is divided.
    const std::vector<std::size_t>& about(std::size_t number) {
        std::optional<std::vector<std::size_t>>& known = about_[number];
        if (!known) {
            known.emplace();
            for (std::size_t axis = 0; axis < 3; ++axis) {
                beside(number, axis, false, *known);
                beside(number, axis, true, *known);
            }
        }
        return *known;
    }

    // The undivided boxes beside a face of one.
    void beside(std::size_t number, std::size_t axis, bool high, std::vector<std::size_t>& found) {
        BoxKey key = boxes_[number].key;
        key.at[axis] += high ? 1 : -1;
        if (key.at[axis] < 0 || key.at[axis] >= 1 << key.level) return;
        auto at = numbers_.find(key.packed());
        while (at == numbers_.end()) {
            key = key.above();
            at = numbers_.find(key.packed());
        }
        std::vector<std::size_t> open{at->second};
        while (!open.empty()) {
            const std::size_t now = open.back();
            open.pop_back();
            if (!boxes_[now].is_divided) {
                // What is out of the region stays so, and no way leads there.
                if (boxes_[now].state != State::out) found.push_back(now);
                continue;
            }
            const BoxKey whole = boxes_[now].key;
            for (int k = 0; k < 8; ++k) {
                // A box of its size or larger gives the halves that touch the face.
                if ((k >> axis & 1) == (high ? 1 : 0)) continue;
                const auto part = numbers_.at(whole.part(k).packed());
                if (touch(boxes_[part].where, boxes_[number].where)) open.push_back(part);
            }
        }
    }
    static bool touch(const SpaceBox& a, const SpaceBox& b) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (a[k].hi < b[k].lo || b[k].hi < a[k].lo) return false;
        }
        return true;
    }

    std::size_t box_at(const SpacePoint& p) const {
        std::size_t now = 0;
        while (boxes_[now].is_divided) {
            int number = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto upper = numbers_.at(boxes_[now].key.part(1 << k).packed());
                if (p[k] >= boxes_[upper].where[k].lo) number |= 1 << k;
            }
            now = numbers_.at(boxes_[now].key.part(number).packed());
        }
        return now;
    }
    Half half_at(const SpacePoint& p) const {
        if (region_.is_outside(point_box(p))) return outside;
        const std::size_t box = box_at(p);
        return half(box, boxes_[box].is_parted && plane_.side(point_box(p)) > 0);
    }

    // Halves that may be reached from this one.
    void neighbours(Half from, std::vector<Half>& found) {
        found.clear();
        if (from == outside) {
            for (std::size_t k = 0; k < boxes_.size(); ++k) {
                const One& one = boxes_[k];
                if (one.is_divided || !one.may_leave || one.state == State::out) continue;
                found.push_back(half(k, false));
                if (one.is_parted) found.push_back(half(k, true));
            }
            return;
        }
        const std::size_t number = box_of(from);
        const One& one = boxes_[number];
        if (one.may_leave) found.push_back(outside);
        for (const std::size_t other : about(number)) {
            if (!one.is_parted && !marks_[other].is_parted) {
                found.push_back(half(other, false));
                continue;
            }
            const One& next = boxes_[other];
            SpaceBox face;
            for (std::size_t k = 0; k < 3; ++k) face[k] = intersect(one.where[k], next.where[k]);
            const int side = plane_.side(face);
            const auto is_open = [&](bool upper) { return side == 0 || (side > 0) == upper; };
            if (one.is_parted && !is_open(is_upper(from))) continue;
            if (!next.is_parted) {
                found.push_back(half(other, false));
                continue;
            }
            for (const bool upper : {false, true}) {
                if (!is_open(upper) || (one.is_parted && upper != is_upper(from))) continue;
                found.push_back(half(other, upper));
            }
        }
    }

    // Halves of boxes that lead from one point to the other, with as few open ones as there are;
    // none if there is no way.
    std::optional<std::vector<Half>> way_between(const std::array<SpacePoint, 2>& starts) {
        const Half from = half_at(starts[0]), to = half_at(starts[1]);
        constexpr int unreached = std::numeric_limits<int>::max();
        reached_.assign(half(boxes_.size(), false), {from, unreached, false});
        reached_[from].cost = 0;
        std::deque<Half> open{from};
        std::vector<Half> next_to;
        while (!open.empty()) {
            const Half now = open.front();
            open.pop_front();
            if (std::exchange(reached_[now].is_done, true)) continue;
            if (now == to) {
                std::vector<Half> way{to};
                while (way.back() != from) way.push_back(reached_[way.back()].before);
                return way;
            }
            neighbours(now, next_to);
            for (const Half next : next_to) {
                const bool is_free = next == outside || marks_[box_of(next)].is_in;
                const int there = reached_[now].cost + (is_free ? 0 : 1);
                if (reached_[next].cost <= there) continue;
                reached_[next].cost = there;
                reached_[next].before = now;
                is_free ? open.push_front(next) : open.push_back(next);
            }
        }
        return std::nullopt;
    }

    const SublevelSet& region_;
    const PartingPlane& plane_;
    const PartingOptions& how_;
    struct Reached {
        Half before; // by which half
        int cost;
        bool is_done;
    };

    std::vector<One> boxes_;
    struct Mark {
        bool is_in = false, is_parted = false;
    };
    std::vector<Mark> marks_; // of each box: small, since searches for ways ask for them most
    std::vector<std::optional<std::vector<std::size_t>>> about_; // of each box, where it is known
    std::vector<Reached> reached_;                               // each half, by the last search
    std::unordered_map<std::uint64_t, std::size_t> numbers_;
    struct Tightened {
        int tried = 0, ended = 0, skipped = 0;
    };
    std::array<Tightened, deepest + 1> tightened_{}; // boxes of each size
};

} // namespace

Sides sides_by_boxes(const SublevelSet& region, const Event& event,
                     const std::array<SpacePoint, 2>& starts, const PartingOptions& how) {
    const auto plane = parting_plane(region, event);
    if (!plane) return Sides::unknown;
    // The two starts have to be on different sides of the plane.
    if (!plane->is_wall &&
        plane->side(point_box(starts[0])) * plane->side(point_box(starts[1])) != -1)
        return Sides::unknown;
    return Boxes(region, *plane, how).sides(starts);
}

} // namespace isomotion::topology
