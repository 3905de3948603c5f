#include "formula/tape/tape.h"

#include <algorithm>
#include <bit>
#include <functional>
#include <map>
#include <tuple>

#include "formula/glsl/exact_results.h"
#include "formula/interval/interval_operations.h"
#include "formula/interval/noise_enclosure.h"
#include "formula/tape/tape_order.h"

namespace isomotion::formula {
namespace {

Interval value_of(const TapeStep& step, const std::array<Interval, 4>& of) {
    using Do = Operations<Interval>;
    const bool is_square = step.op == Op::multiply && step.operands[0] == step.operands[1];
    if (is_square) return Do::square(of[0]);
    switch (step.op) {
    case Op::negate:
        return Do::negate(of[0]);
#define CASE(name, ...)                                                                            \
    case Op::name:                                                                                 \
        return Do::name(of[0]);
        ISOMOTION_FUNCTIONS(CASE)
#undef CASE
#define CASE(name, ...)                                                                            \
    case Op::name:                                                                                 \
        return Do::name(of[0], of[1]);
        ISOMOTION_OPERATIONS_OF_TWO(CASE)
#undef CASE
    case Op::select:
        return Do::select(of[0], of[1], of[2], of[3]);
    case Op::noise:
        return NoiseEnclosure(NoiseOrder::unpacked(step.index))(of[0], of[1], of[2]);
    default: // chebyshev: nothing is decided by its values
        return Interval::entire();
    }
}

// `used` becomes the steps that outputs need, in their order. stand_in(k) is the step that serves
// for step k: itself or an earlier one. `place` is overwritten.
template<class StandIn>
void keep_needed(std::span<const TapeStep> steps, std::span<const int> outputs,
                 const StandIn& stand_in, std::vector<int>& place, Tape& used) {
    place.assign(steps.size(), -1);
    std::size_t count = 0;
    const auto need = [&](int step) {
        count += place[std::size_t(step)] < 0;
        place[std::size_t(step)] = 0;
    };
    std::ranges::for_each(outputs, need);
    for (std::size_t k = steps.size(); k-- > 0;) {
        if (place[k] < 0) continue;
        if (const int other = stand_in(int(k)); other != int(k))
            need(other);
        else
            std::for_each_n(steps[k].operands.begin(), steps[k].arity, need);
    }
    used.steps.clear();
    used.outputs.clear();
    used.steps.reserve(count);
    for (std::size_t k = 0; k < steps.size(); ++k) {
        if (place[k] < 0) continue;
        if (const int other = stand_in(int(k)); other != int(k)) {
            place[k] = place[std::size_t(other)];
            continue;
        }
        place[k] = int(used.steps.size());
        TapeStep& step = used.steps.emplace_back(steps[k]);
        for (std::size_t o = 0; o < step.arity; ++o)
            step.operands[o] = place[std::size_t(step.operands[o])];
        if (step.follows >= 0) step.follows = place[std::size_t(step.follows)];
    }
    for (const int output : outputs) used.outputs.push_back(place[std::size_t(output)]);
}

bool is_extreme(const TapeStep& step) { return step.op == Op::min || step.op == Op::max; }

// Tells selects that are slopes of a min or max which one that is. Only slopes of F may need them.
void link_slopes(Tape& tape, const std::vector<bool>& for_values) {
    std::map<std::tuple<Op, int, int>, int> extremes; // by what they compare
    for (std::size_t k = 0; k < tape.steps.size(); ++k) {
        const TapeStep& step = tape.steps[k];
        if (is_extreme(step)) extremes[{step.op, step.operands[0], step.operands[1]}] = int(k);
    }
    for (std::size_t k = 0; k < tape.steps.size(); ++k) {
        TapeStep& step = tape.steps[k];
        if (step.op != Op::select || for_values[k]) continue;
        const auto known = extremes.find({Op(step.index), step.operands[0], step.operands[1]});
        if (known != extremes.end()) step.follows = known->second;
    }
}

bool is_finite(Interval a) { return a.lo > -infinity && a.hi < infinity; }
bool is(Interval a, double number) { return a.lo == number && a.hi == number; }

// Adds steps, each once.
class Joiner {
public:
    explicit Joiner(std::vector<TapeStep>& steps)
        : steps_(steps) {}

    int step(const TapeStep& step) {
        const Key key{step.op,
                      step.is_exact,
                      step.index,
                      step.second,
                      std::bit_cast<std::uint64_t>(step.value.lo),
                      std::bit_cast<std::uint64_t>(step.value.hi),
                      step.operands};
        const auto [known, is_new] = known_.try_emplace(key, int(steps_.size()));
        if (is_new) steps_.push_back(step);
        return known->second;
    }

private:
    using Key = std::tuple<Op, bool, int, int, std::uint64_t, std::uint64_t, std::array<int, 4>>;
    std::vector<TapeStep>& steps_;
    std::map<Key, int> known_;
};

// Constants that rounding left wide stay as they are computed.
bool is_narrow(Interval a) { return is_finite(a) && a.hi - a.lo <= 0x1p-40 * magnitude(a); }

} // namespace

void Specialiser::operator()(const Tape& tape, std::span<const Interval> inputs, Tape& shortened) {
    made_.clear();
    values_.clear();
    stands_for_.clear();
    outputs_.clear();
    for (const TapeStep& step : tape.steps) stands_for_.push_back(next(step, inputs));
    for (const int output : tape.outputs) outputs_.push_back(stands_for_[std::size_t(output)]);
    find_wanted();
    const auto stand_in = [&](int step) { return this->stand_in(step); };
    keep_needed(made_, outputs_, stand_in, place_, shortened);
}

int Specialiser::next(TapeStep step, std::span<const Interval> inputs) {
    if (step.op == Op::constant) return constant(step.value);
    if (step.op == Op::input) return add(step, inputs[std::size_t(step.index)]);
    std::array<Interval, 4> of{};
    bool all_constant = true;
    for (std::size_t k = 0; k < step.arity; ++k) {
        step.operands[k] = stands_for_[std::size_t(step.operands[k])];
        of[k] = values_[std::size_t(step.operands[k])];
        all_constant &= is_constant(step.operands[k]);
    }
    if (const auto simpler = chosen(step, of)) return *simpler;
    if (step.follows >= 0) {
        step.follows = stands_for_[std::size_t(step.follows)];
        if (!is_extreme(made_[std::size_t(step.follows)])) step.follows = -1;
    }
    const Interval value = value_of(step, of);
    const bool is_known = is_point(value) || (all_constant && is_narrow(value));
    return is_known ? constant(value) : add(step, value);
}

// The step that a choice comes to, or arithmetic that changes nothing.
std::optional<int> Specialiser::chosen(const TapeStep& step, const std::array<Interval, 4>& of) {
    const int a = step.operands[0], b = step.operands[1];
    switch (step.op) {
    case Op::abs:
        if (of[0].lo >= 0) return a;
        if (of[0].hi <= 0) return negated(a);
        break;
    case Op::min:
    case Op::max: {
        const bool least = step.op == Op::min;
        if (a == b) return a;
        if (of[0].hi < of[1].lo) return least ? a : b;
        if (of[0].lo >= of[1].hi) return least ? b : a;
        break;
    }
    case Op::select:
        if (of[0].hi < of[1].lo) return step.operands[2];
        if (of[0].lo >= of[1].hi) return step.operands[3];
        if (step.operands[2] == step.operands[3]) return step.operands[2];
        break;
    case Op::add:
        if (is(of[0], 0)) return b;
        if (is(of[1], 0)) return a;
        break;
    case Op::subtract:
        if (is(of[1], 0)) return a;
        if (is(of[0], 0)) return negated(b);
        break;
    case Op::multiply:
        for (std::size_t k = 0; k < 2; ++k) {
            const int other = step.operands[1 - k];
            if (is(of[k], 1)) return other;
            if (is(of[k], -1)) return negated(other);
            if (is(of[k], 0) && is_finite(of[1 - k])) return constant(0);
        }
        break;
    default:
        break;
    }
    return {};
}

int Specialiser::negated(int of) {
    const TapeStep& step = made_[std::size_t(of)];
    if (step.op == Op::constant) return constant(-step.value);
    if (step.op == Op::negate) return step.operands[0];
    return add({.op = Op::negate, .arity = 1, .operands = {of}}, -values_[std::size_t(of)]);
}

bool Specialiser::is_constant(int step) const {
    return made_[std::size_t(step)].op == Op::constant;
}

int Specialiser::constant(Interval value) { return add({.value = value}, value); }

int Specialiser::add(const TapeStep& step, Interval value) {
    made_.push_back(step);
    values_.push_back(value);
    return int(made_.size()) - 1;
}

// Values of a step beyond its wanted range all come to the same outputs. What wants a step comes
// behind it.
void Specialiser::find_wanted() {
    using Do = Operations<Interval>;
    constexpr Interval none{infinity, -infinity};
    wanted_.assign(made_.size(), none);
    for (const int output : outputs_) want(output, Interval::entire());
    for (std::size_t k = made_.size(); k-- > 0;) {
        const Interval range = wanted_[k], value = values_[k];
        if (range.lo > range.hi) continue;
        const TapeStep& step = made_[k];
        const int a = step.operands[0], b = step.operands[1];
        const auto want_both = [&](Interval of) {
            want(a, of);
            want(b, of);
        };
        switch (step.op) {
        case Op::min:
            want_both({range.lo, std::min(range.hi, value.hi)});
            continue;
        case Op::max:
            want_both({std::max(range.lo, value.lo), range.hi});
            continue;
        case Op::negate:
            want(a, -range);
            continue;
        case Op::abs:
            want(a, {-range.hi, range.hi});
            continue;
        case Op::add:
            if (is_constant(b)) {
                want(a, Do::subtract(range, values_[std::size_t(b)]));
                continue;
            }
            break;
        case Op::subtract:
            if (is_constant(b)) {
                want(a, Do::add(range, values_[std::size_t(b)]));
                continue;
            }
            break;
        case Op::select:
            if (step.follows < 0) break;
            want(step.operands[2], Interval::entire());
            want(step.operands[3], Interval::entire());
            continue;
        default:
            break;
        }
        for (std::size_t o = 0; o < step.arity; ++o) want(step.operands[o], Interval::entire());
    }
}

void Specialiser::want(int step, Interval range) {
    Interval& all = wanted_[std::size_t(step)];
    all = {std::min(all.lo, range.lo), std::max(all.hi, range.hi)};
}

// The step that serves for a min, a max or a slope of these whose one side has no wanted value, or
// the step itself. The other side has a value wherever its bounds say so.
int Specialiser::stand_in(int step) const {
    const TapeStep& at = made_[std::size_t(step)];
    const bool chooses = is_extreme(at) || (at.op == Op::select && at.follows >= 0);
    if (!chooses) return step;
    const int extreme = at.op == Op::select ? at.follows : step;
    const bool least = made_[std::size_t(extreme)].op == Op::min;
    const Interval wanted = wanted_[std::size_t(extreme)];
    const auto is_unwanted = [&](int side) {
        const Interval value = values_[std::size_t(at.operands[std::size_t(side)])];
        return least ? value.lo > std::min(wanted.hi, values_[std::size_t(extreme)].hi)
                     : value.hi < std::max(wanted.lo, values_[std::size_t(extreme)].lo);
    };
    if (wanted.lo > wanted.hi) return step;
    const auto taken = [&](int side) {
        if (at.op != Op::select) return at.operands[std::size_t(side)];
        return at.operands[least == (side == 0) ? 2 : 3];
    };
    const auto has_value = [&](int side) {
        const Interval value = values_[std::size_t(at.operands[std::size_t(side)])];
        return value.lo > -infinity || value.hi < infinity;
    };
    if (is_unwanted(0) && has_value(1)) return taken(1);
    if (is_unwanted(1) && has_value(0)) return taken(0);
    return step;
}

std::optional<Tape> tape_of(std::span<const TapeSource> sources) {
    Tape tape;
    Joiner joiner(tape.steps);
    std::vector<bool> is_slope; // of the outputs
    for (const auto& [program, values, slopes] : sources) {
        std::vector<int> place(std::size_t(program.registers), -1);
        const std::vector<bool> exact = exact_results(program);
        for (const Instruction& now : program.instructions) {
            const bool is_known = now.kind == Instruction::Kind::operation &&
                                  now.op != Op::element && now.op != Op::random;
            if (!is_known) return {};
            TapeStep step{
                .op = now.op, .arity = now.arity, .index = now.index, .second = now.second};
            step.is_exact = exact[std::size_t(now.result)];
            if (now.op == Op::constant) step.value = now.value;
            for (std::size_t k = 0; k < now.arity; ++k)
                step.operands[k] = place[std::size_t(now.operands[k])];
            place[std::size_t(now.result)] = joiner.step(step);
        }
        for (const Register output : program.outputs)
            tape.outputs.push_back(place[std::size_t(output)]);
        for (int o = 0; o < int(program.outputs.size()); ++o)
            is_slope.push_back(o >= values && o < values + slopes);
    }
    link_slopes(tape, steps_of_values(tape, is_slope));
    return in_short_order(tape, is_slope);
}

Tape with_parameters(Tape tape, std::span<const Interval> parameters) {
    for (TapeStep& step : tape.steps) {
        if (step.op == Op::parameter) step = {.value = parameters[std::size_t(step.index)]};
    }
    return tape;
}

Tape part_of(const Tape& tape, int first, int count) {
    std::vector<int> place;
    Tape part;
    const auto itself = [](int step) { return step; };
    keep_needed(tape.steps, std::span(tape.outputs).subspan(std::size_t(first), std::size_t(count)),
                itself, place, part);
    return part;
}

} // namespace isomotion::formula
