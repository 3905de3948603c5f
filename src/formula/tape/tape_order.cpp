#include "formula/tape/tape_order.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <span>
#include <utility>

namespace isomotion::formula {
namespace {

// For each step, how many values are kept at a time until it is known, were nothing shared: the
// operand that needs most is computed first (Sethi and Ullman 1970).
std::vector<int> values_kept(std::span<const TapeStep> steps) {
    std::vector<int> kept;
    kept.reserve(steps.size());
    for (const TapeStep& step : steps) {
        std::array<int, 4> of{};
        for (std::size_t o = 0; o < step.arity; ++o) of[o] = kept[std::size_t(step.operands[o])];
        std::ranges::sort(of, std::greater<>());
        int most = 1;
        for (int o = 0; o < int(step.arity); ++o) most = std::max(most, of[std::size_t(o)] + o);
        kept.push_back(most);
    }
    return kept;
}

bool is_leaf(const TapeStep& step) { return step.arity == 0; }

// The steps that use each step, and how many of them have no place yet.
class Uses {
public:
    explicit Uses(const Tape& tape)
        : first_(tape.steps.size() + 1, 0) {
        for_each_use(tape, [&](int of, int) { ++first_[std::size_t(of) + 1]; });
        for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
        by_.resize(std::size_t(first_.back()));
        std::vector<int> next(first_.begin(), first_.end() - 1);
        for_each_use(tape, [&](int of, int by) { by_[std::size_t(next[std::size_t(of)]++)] = by; });
        for (std::size_t k = 0; k + 1 < first_.size(); ++k)
            waiting_.push_back(first_[k + 1] - first_[k]);
    }

    std::span<const int> of(int step) const {
        const auto k = std::size_t(step);
        return std::span(by_).subspan(std::size_t(first_[k]), std::size_t(waits_at_first(k)));
    }
    int waiting(int step) const { return waiting_[std::size_t(step)]; }
    void has_place(const TapeStep& step) {
        for (std::size_t o = 0; o < step.arity; ++o) --waiting_[std::size_t(step.operands[o])];
    }

private:
    template<class Use> static void for_each_use(const Tape& tape, const Use& use) {
        for (std::size_t k = 0; k < tape.steps.size(); ++k) {
            const TapeStep& step = tape.steps[k];
            for (std::size_t o = 0; o < step.arity; ++o) use(step.operands[o], int(k));
        }
    }
    int waits_at_first(std::size_t k) const { return first_[k + 1] - first_[k]; }

    std::vector<int> first_, by_, waiting_;
};

enum class Haste {
    none,
    // What can be computed is, at once, where it takes the place of an operand: the sum of terms
    // that a slope needs, too, before all of them are there.
    where_it_frees,
};

// Puts a tape's steps in another order.
class Order {
public:
    Order(const Tape& tape, Haste haste)
        : tape_(tape)
        , haste_(haste)
        , uses_(tape)
        , kept_(values_kept(tape.steps))
        , place_(tape.steps.size(), -1) {
        ordered_.steps.reserve(tape.steps.size());
    }

    // Adds the step, after those that it needs and that are not there yet. What a select follows
    // comes before it.
    void add(int wanted) {
        struct Open {
            int step;
            std::size_t next; // operand to look at
        };
        std::vector<Open> open{{wanted, 0}};
        while (!open.empty()) {
            auto& [at, next] = open.back();
            const TapeStep& step = tape_.steps[std::size_t(at)];
            if (has(at)) {
                open.pop_back();
            } else if (next < step.arity) {
                const int first = operand(step, next);
                ++next;
                open.push_back({first, 0});
            } else if (step.follows >= 0 && !has(step.follows)) {
                open.push_back({step.follows, 0});
            } else {
                put(at);
                open.pop_back();
            }
        }
    }

    bool has(int step) const { return place(step) >= 0; }
    int place(int step) const { return place_[std::size_t(step)]; }

    Tape take() {
        for (const int output : tape_.outputs) ordered_.outputs.push_back(place(output));
        return std::move(ordered_);
    }

private:
    void put(int wanted) {
        std::vector<int> fresh{wanted};
        while (!fresh.empty()) {
            const int at = fresh.back();
            fresh.pop_back();
            if (has(at)) continue;
            const TapeStep& step = tape_.steps[std::size_t(at)];
            place_[std::size_t(at)] = int(ordered_.steps.size());
            TapeStep& copy = ordered_.steps.emplace_back(step);
            for (std::size_t o = 0; o < step.arity; ++o) copy.operands[o] = place(step.operands[o]);
            if (step.follows >= 0) copy.follows = place(step.follows);
            uses_.has_place(step);
            if (haste_ == Haste::none || is_leaf(step)) continue;
            const auto hasten_uses = [&](int of) {
                for (const int use : uses_.of(of)) {
                    if (!has(use) && is_ready(use)) fresh.push_back(use);
                }
            };
            for (std::size_t o = 0; o < step.arity; ++o) {
                if (uses_.waiting(step.operands[o]) == 1) hasten_uses(step.operands[o]);
            }
            hasten_uses(at);
        }
    }

    // Whether all operands are there, and one of them is needed for nothing else.
    bool is_ready(int at) const {
        const TapeStep& step = tape_.steps[std::size_t(at)];
        if (step.follows >= 0 && !has(step.follows)) return false;
        bool frees = false;
        for (std::size_t o = 0; o < step.arity; ++o) {
            const int of = step.operands[o];
            if (!has(of)) return false;
            frees = frees || (uses_.waiting(of) == 1 && !is_leaf(tape_.steps[std::size_t(of)]));
        }
        return frees;
    }

    // The operand to be looked at as number `next`.
    int operand(const TapeStep& step, std::size_t next) const {
        constexpr std::array<std::size_t, 4> of_select{2, 0, 3, 1}; // a slope asks for its values
        std::array<std::size_t, 4> order{0, 1, 2, 3};
        if (step.op == Op::select) order = of_select;
        std::ranges::stable_sort(
            std::span(order).first(step.arity), std::greater<>(),
            [&](std::size_t o) { return kept_[std::size_t(step.operands[o])]; });
        return step.operands[order[next]];
    }

    const Tape& tape_;
    const Haste haste_;
    Uses uses_;
    std::vector<int> kept_, place_;
    Tape ordered_;
};

// How many values the steps keep at a time.
int most_kept(const Tape& tape) {
    std::vector<int> ends(tape.steps.size() + 1, 0); // values whose last use is there
    std::vector<std::size_t> last_use(tape.steps.size());
    for (std::size_t k = 0; k < tape.steps.size(); ++k) {
        for (std::size_t o = 0; o < tape.steps[k].arity; ++o)
            last_use[std::size_t(tape.steps[k].operands[o])] = k;
    }
    for (const int output : tape.outputs) last_use[std::size_t(output)] = tape.steps.size();
    const auto is_in_words = [](const TapeStep& step) {
        return step.op == Op::constant || step.op == Op::parameter;
    };
    int kept = 0, most = 0;
    for (std::size_t k = 0; k < tape.steps.size(); ++k) {
        if (is_in_words(tape.steps[k])) continue;
        ++ends[last_use[k]];
        most = std::max(most, ++kept);
        kept -= ends[k];
    }
    return most;
}

// The last output first, as it is a slope of the first, and values where slopes ask for them.
Tape values_in_slopes(const Tape& tape, Haste haste) {
    Order order(tape, haste);
    for (auto output = tape.outputs.rbegin(); output != tape.outputs.rend(); ++output)
        order.add(*output);
    return order.take();
}

// The places of all values, in an order that keeps few of them. Slopes have none.
std::vector<int> short_places(const Tape& tape, const std::vector<bool>& for_values) {
    Order values(tape, Haste::none);
    for (const int output : tape.outputs) {
        if (for_values[std::size_t(output)]) values.add(output);
    }
    std::vector<int> places;
    for (std::size_t k = 0; k < tape.steps.size(); ++k) places.push_back(values.place(int(k)));
    return places;
}

// The places that steps have by now.
std::vector<int> written_places(const Tape& tape) {
    std::vector<int> places(tape.steps.size());
    std::iota(places.begin(), places.end(), 0);
    return places;
}

// Each value's slope as soon as the values that it needs are there, as in forward differentiation.
// A product of long sums needs their values and their slopes; one after the other would keep a
// value for each term. Values have these places among each other.
Tape slopes_behind_values(const Tape& tape, const std::vector<bool>& for_values,
                          const std::vector<int>& places, Haste haste) {
    // For each step the last value, in that order, that it needs, as far as `counts` says; -1
    // without any.
    const auto last_needed = [&](const auto& counts) {
        std::vector<int> needs(tape.steps.size(), -1);
        for (std::size_t k = 0; k < tape.steps.size(); ++k) {
            const TapeStep& step = tape.steps[k];
            if (for_values[k]) {
                if (counts(k)) needs[k] = places[k];
                continue;
            }
            for (std::size_t o = 0; o < step.arity; ++o)
                needs[k] = std::max(needs[k], needs[std::size_t(step.operands[o])]);
            if (step.follows >= 0) needs[k] = std::max(needs[k], needs[std::size_t(step.follows)]);
        }
        return needs;
    };
    // A value that is kept for long is there for slopes whenever they are wanted: x^2, which all
    // terms share. Slopes that are taken as soon as it is there would only be kept beside it.
    std::vector<int> last_use(tape.steps.size(), 0); // in that order, about
    const std::vector<int> all_needs = last_needed([](std::size_t) { return true; });
    for (std::size_t k = 0; k < tape.steps.size(); ++k) {
        for (std::size_t o = 0; o < tape.steps[k].arity; ++o) {
            int& last = last_use[std::size_t(tape.steps[k].operands[o])];
            last = std::max(last, all_needs[k]);
        }
    }
    constexpr int long_after = 32;
    const std::vector<int> needs = last_needed([&](std::size_t k) {
        return !is_leaf(tape.steps[k]) && last_use[k] - places[k] <= long_after;
    });
    // Slopes that no other step needs before a further value is there, by the last value.
    std::vector<std::vector<int>> slopes(tape.steps.size());
    std::vector<bool> is_needed_at_once(tape.steps.size(), false);
    std::vector<int> value_at; // by place
    for (std::size_t k = 0; k < tape.steps.size(); ++k) {
        const TapeStep& step = tape.steps[k];
        if (for_values[k]) {
            const auto place = std::size_t(places[k]);
            value_at.resize(std::max(value_at.size(), place + 1), -1);
            value_at[place] = int(k);
            continue;
        }
        for (std::size_t o = 0; o < step.arity; ++o) {
            const auto of = std::size_t(step.operands[o]);
            if (needs[of] == needs[k]) is_needed_at_once[of] = true;
        }
    }
    for (std::size_t k = 0; k < tape.steps.size(); ++k) {
        if (!for_values[k] && needs[k] >= 0 && !is_needed_at_once[k])
            slopes[std::size_t(needs[k])].push_back(int(k));
    }
    Order order(tape, haste);
    for (std::size_t at = 0; at < value_at.size(); ++at) {
        if (value_at[at] < 0) continue;
        order.add(value_at[at]);
        for (const int slope : slopes[at]) order.add(slope);
    }
    for (const int output : tape.outputs) order.add(output);
    return order.take();
}

// For each step, how many steps compute it from leaves, if these are few and quick; else 0.
std::vector<int> steps_from_leaves(const Tape& tape) {
    constexpr int few = 6;
    std::vector<int> counts;
    for (const TapeStep& step : tape.steps) {
        const bool is_cheap = step.op == Op::negate || step.op == Op::add ||
                              step.op == Op::subtract || step.op == Op::multiply ||
                              step.op == Op::abs || step.op == Op::sign;
        int count = is_cheap ? 1 : 0;
        for (std::size_t o = 0; count > 0 && o < step.arity; ++o) {
            const auto of = std::size_t(step.operands[o]);
            if (is_leaf(tape.steps[of])) continue;
            count = counts[of] > 0 && count + counts[of] <= few ? count + counts[of] : 0;
        }
        counts.push_back(count);
    }
    return counts;
}

// The same function with what is cheap computed anew where it is needed much later, so that nothing
// is kept for it.
Tape with_cheap_steps_repeated(const Tape& tape) {
    constexpr std::size_t much_later = 100;
    const std::vector<int> cheap = steps_from_leaves(tape);
    std::vector<int> place(tape.steps.size(), -1);
    std::vector<std::size_t> last_use(tape.steps.size(), 0);
    Tape made;
    const auto add = [&](const auto& add, std::size_t k) -> int {
        TapeStep copy = tape.steps[k];
        for (std::size_t o = 0; o < copy.arity; ++o) {
            const auto of = std::size_t(copy.operands[o]);
            const bool is_far = place[of] < 0 || made.steps.size() - last_use[of] > much_later;
            if (cheap[of] > 0 && is_far) add(add, of);
            last_use[of] = made.steps.size();
            copy.operands[o] = place[of];
        }
        if (copy.follows >= 0) copy.follows = place[std::size_t(copy.follows)];
        made.steps.push_back(copy);
        last_use[k] = made.steps.size();
        return place[k] = int(made.steps.size()) - 1;
    };
    for (std::size_t k = 0; k < tape.steps.size(); ++k) {
        if (cheap[k] == 0) add(add, k);
    }
    for (const int output : tape.outputs) {
        const auto of = std::size_t(output);
        made.outputs.push_back(place[of] < 0 ? add(add, of) : place[of]);
    }
    return made;
}

} // namespace

std::vector<bool> steps_of_values(const Tape& tape, const std::vector<bool>& is_slope) {
    std::vector<bool> for_values(tape.steps.size(), false);
    for (std::size_t o = 0; o < tape.outputs.size(); ++o) {
        if (!is_slope[o]) for_values[std::size_t(tape.outputs[o])] = true;
    }
    for (std::size_t k = tape.steps.size(); k-- > 0;) {
        const TapeStep& step = tape.steps[k];
        for (std::size_t o = 0; for_values[k] && o < step.arity; ++o)
            for_values[std::size_t(step.operands[o])] = true;
    }
    return for_values;
}

Tape in_short_order(const Tape& tape, const std::vector<bool>& is_slope) {
    const std::vector<bool> for_values = steps_of_values(tape, is_slope);
    constexpr int few = 32; // values that another order need not keep fewer than
    Tape best = values_in_slopes(tape, Haste::none);
    int least = most_kept(best);
    if (least <= few) return best;
    const auto offer = [&](Tape other) {
        const int most = most_kept(other);
        if (most >= least) return;
        least = most;
        best = std::move(other);
    };
    const std::vector<int> short_order = short_places(tape, for_values);
    const std::vector<int> written_order = written_places(tape);
    for (const Haste haste : {Haste::none, Haste::where_it_frees}) {
        if (haste != Haste::none && least > few) offer(values_in_slopes(tape, haste));
        for (const std::vector<int>& places : {short_order, written_order}) {
            if (least > few) offer(slopes_behind_values(tape, for_values, places, haste));
        }
    }
    constexpr int many = 500;
    return least > many ? with_cheap_steps_repeated(best) : best;
}

} // namespace isomotion::formula
