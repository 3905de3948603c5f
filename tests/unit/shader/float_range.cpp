#include "float_range.h"

#include <cassert>

#include "range_operations.h"

#include "formula/interval/interval_operations.h"

namespace isomotion::shader {
namespace {

using formula::Instruction;
using formula::Op;

class Run {
public:
    Run(const formula::Program& program, const formula::Bindings<double>& bindings,
        std::span<const double> inputs)
        : program_(program)
        , bindings_(bindings)
        , inputs_(inputs)
        , registers_(std::size_t(program.registers))
        , element_(bindings.arrays.size()) {}

    FloatRanges take() {
        block(0, program_.instructions.size());
        FloatRanges result;
        for (const formula::Register r : program_.outputs) {
            result.outputs.push_back(registers_[std::size_t(r)]);
        }
        result.saturated = saturated_;
        result.strained = strained_;
        return result;
    }

private:
    void block(std::size_t at, std::size_t end) {
        for (; at < end; ++at) {
            const Instruction& now = program_.instructions[at];
            if (now.kind == Instruction::Kind::loop_begin) {
                const std::size_t last = matching_end(at);
                const auto array = std::size_t(now.index);
                for (int e = 0; e < bindings_.arrays[array].count; ++e) {
                    element_[array] = std::size_t(e);
                    block(at + 1, last);
                }
                at = last;
                continue;
            }
            Range& to = registers_[std::size_t(now.result)];
            if (now.kind == Instruction::Kind::begin) {
                begin(now, to);
                continue;
            } else if (now.kind == Instruction::Kind::accumulate) {
                accumulate(now, to);
            } else {
                to = now.arity == 0 ? leaf(now) : operation(now);
            }
            note(now, ranges::size(to), to.nan);
        }
    }

    // What is the least of none counts as cut off only where it stays or keys are beyond it.
    void begin(const Instruction& now, Range& to) {
        const Range none{ranges::saturation, ranges::saturation, false};
        to = now.op == Op::least ? none : Range{};
        if (formula::keeps_least(now.op)) registers_[std::size_t(now.operands[2])] = none;
        const bool is_empty = bindings_.arrays[std::size_t(now.index)].count == 0;
        saturated_ = saturated_ || (now.op == Op::least && is_empty);
    }

    void accumulate(const Instruction& now, Range& to) {
        const Range& key = operand(now, 0);
        if (now.op != Op::sum) note(now, ranges::size(key), key.nan);
        if (now.op == Op::sum) {
            to = ranges::add(to, key);
        } else if (now.op == Op::least) {
            to = ranges::min(key, to);
        } else {
            Range& least = registers_[std::size_t(now.operands[2])];
            to = ranges::select(key, least, operand(now, 1), to);
            least = ranges::min(key, least);
        }
    }

    void note(const Instruction& now, double size, bool nan) {
        saturated_ = saturated_ || nan || size >= ranges::saturation;
        const bool unbounded = now.kind == Instruction::Kind::operation &&
                               (now.op == Op::multiply || now.op == Op::input);
        strained_ = strained_ || (unbounded && size >= 0x1p64);
    }

    std::size_t matching_end(std::size_t begin) const {
        int depth = 0;
        for (std::size_t at = begin;; ++at) {
            const auto kind = program_.instructions[at].kind;
            if (kind == Instruction::Kind::loop_begin) ++depth;
            if (kind == Instruction::Kind::loop_end && --depth == 0) return at;
        }
    }

    const Range& operand(const Instruction& now, std::size_t k) const {
        return registers_[std::size_t(now.operands[k])];
    }

    Range leaf(const Instruction& now) const {
        const auto index = std::size_t(now.index);
        const auto exactly = [](double v) { return ranges::grown({v, v}, 0, 0); };
        switch (now.op) {
        case Op::constant: { // a float in a shader, whatever the formula says
            const double v = std::clamp(now.value, -ranges::largest, ranges::largest);
            return ranges::grown(ranges::hull({v, double(float(v))}), 0, 0);
        }
        case Op::input:
            return exactly(inputs_[index]);
        case Op::parameter:
            return exactly(bindings_.parameters[index]);
        default: {
            assert(now.op == Op::element);
            const auto& column = bindings_.arrays[index].fields[std::size_t(now.second)];
            return exactly(column[element_[index]]);
        }
        }
    }

    Range operation(const Instruction& now) const {
        const Range& a = operand(now, 0);
        const Range& b = now.arity > 1 ? operand(now, 1) : a;
        const auto unit_interval = [](double v) { return std::clamp(v, -1.0, 1.0); };
        switch (now.op) {
        case Op::negate:
            return ranges::negate(a);
        case Op::abs:
            return ranges::abs(a);
        case Op::sign:
            return ranges::sign(a);
        case Op::floor:
            return {std::floor(a.low), std::floor(a.high), a.nan};
        case Op::sqrt:
            return ranges::rounded(
                ranges::increasing(a, 0, [](double v) { return std::sqrt(std::max(v, 0.0)); }));
        case Op::exp:
            return ranges::increasing(a, 3, [](double v) { return ranges::saturate(std::exp(v)); });
        case Op::log:
            return ranges::log(a);
        case Op::sin:
            return ranges::sin(a);
        case Op::cos:
            return ranges::cos(a);
        case Op::tan:
            return ranges::tan(a);
        case Op::sinh:
            return ranges::increasing(a, 5,
                                      [](double v) { return ranges::saturate(std::sinh(v)); });
        case Op::cosh:
            return ranges::cosh(a);
        case Op::tanh:
            return ranges::increasing(a, 4, [](double v) { return std::tanh(v); });
        case Op::asin:
            return ranges::increasing(a, 4, [&](double v) { return std::asin(unit_interval(v)); });
        case Op::acos:
            return ranges::acos(a);
        case Op::atan:
            return ranges::increasing(a, 6, [](double v) { return std::atan(v); });
        case Op::asinh:
            return ranges::increasing(a, 6, [](double v) { return std::asinh(v); });
        case Op::acosh:
            return ranges::increasing(a, 8, [](double v) { return std::acosh(std::max(v, 1.0)); });
        case Op::erf:
            return ranges::increasing(a, 5, [](double v) { return std::erf(v); });
        case Op::cbrt:
            return ranges::increasing(a, 4, [](double v) { return std::cbrt(v); });
        case Op::atan2:
        case Op::angle: {
            using Do = formula::Operations<formula::Interval>;
            const formula::Interval all = Do::atan2({a.low, a.high}, {b.low, b.high});
            const double off = 8 * 0x1p-24 * magnitude(all); // 8 halves of a float's last bit
            return {all.lo - off, all.hi + off, a.nan || b.nan};
        }
        case Op::add:
            return ranges::add(a, b);
        case Op::subtract:
            return ranges::add(a, ranges::negate(b));
        case Op::multiply:
            return ranges::multiply(a, b);
        case Op::divide:
            return ranges::divide(a, b);
        case Op::min:
            return ranges::min(a, b);
        case Op::max:
            return ranges::max(a, b);
        case Op::power:
            return ranges::power(a, b);
        case Op::select:
            return ranges::select(a, b, operand(now, 2), operand(now, 3));
        default:
            assert(!"no operation of a lowered field");
            return ranges::anything();
        }
    }

    const formula::Program& program_;
    const formula::Bindings<double>& bindings_;
    std::span<const double> inputs_;
    std::vector<Range> registers_;
    std::vector<std::size_t> element_; // of each array's loop
    bool saturated_ = false, strained_ = false;
};

} // namespace

FloatRanges float_ranges(const formula::Program& program, const formula::Bindings<double>& bindings,
                         std::span<const double> inputs) {
    return Run(program, bindings, inputs).take();
}

} // namespace isomotion::shader
