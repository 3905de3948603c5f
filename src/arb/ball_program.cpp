#include "arb/ball_program.h"

#include <arb_hypgeom.h>

#include <algorithm>
#include <stdexcept>

#include "arb/ball_noise.h"

namespace isomotion::ball {
namespace {

using formula::Instruction;
using formula::Op;

class Arf {
public:
    Arf() { arf_init(value_); }
    Arf(const Arf&) = delete;
    Arf& operator=(const Arf&) = delete;
    ~Arf() { arf_clear(value_); }
    arf_ptr get() { return value_; }

private:
    arf_t value_;
};

void set_interval(Ball& to, Arf& low, Arf& high, slong precision) {
    arb_set_interval_arf(to.get(), low.get(), high.get(), precision);
}

// A monotone function, from its values at the ends of a. at(end) makes the value of an end.
template<class At> void monotone(Ball& to, const Ball& a, slong precision, const At& at) {
    if (!a.is_finite()) {
        arb_indeterminate(to.get());
        return;
    }
    Arf arfs[2];
    arb_get_interval_arf(arfs[0].get(), arfs[1].get(), a.get(), precision);
    Ball ends[2];
    for (int k = 0; k < 2; ++k) at(ends[k], arfs[k]);
    arb_union(to.get(), ends[0].get(), ends[1].get(), precision);
}

// asin or acos of the part of a inside [-1, 1]; beyond, of the end.
void arc(Ball& to, const Ball& a, void (*function)(arb_t, const arb_t, slong), slong precision) {
    monotone(to, a, precision, [&](Ball& value, Arf& end) {
        if (arf_cmp_si(end.get(), 1) > 0) arf_one(end.get());
        if (arf_cmp_si(end.get(), -1) < 0) arf_set_si(end.get(), -1);
        arb_set_arf(value.get(), end.get());
        function(value.get(), value.get(), precision);
    });
}

// The operations, named as in their table (formula/graph/function_table.h).
namespace functions {

void abs(Ball& to, const Ball& a, slong precision) {
    if (!arb_contains_zero(a.get()) || arb_is_exact(a.get())) {
        arb_abs(to.get(), a.get());
        return;
    }
    Arf zero, high;
    arb_get_abs_ubound_arf(high.get(), a.get(), precision);
    set_interval(to, zero, high, precision);
}

void sign(Ball& to, const Ball& a, slong) { arb_sgn(to.get(), a.get()); }

void sqrt(Ball& to, const Ball& a, slong precision) {
    if (arb_is_nonpositive(a.get())) {
        arb_zero(to.get());
    } else {
        arb_sqrtpos(to.get(), a.get(), precision);
    }
}

void asin(Ball& to, const Ball& a, slong precision) { arc(to, a, arb_asin, precision); }
void acos(Ball& to, const Ball& a, slong precision) { arc(to, a, arb_acos, precision); }

void acosh(Ball& to, const Ball& a, slong precision) {
    monotone(to, a, precision, [&](Ball& value, Arf& end) {
        if (arf_cmp_si(end.get(), 1) <= 0) return; // 0
        arb_set_arf(value.get(), end.get());
        arb_acosh(value.get(), value.get(), precision);
    });
}

// Arb has roots of positive numbers.
void cbrt(Ball& to, const Ball& a, slong precision) {
    monotone(to, a, precision, [&](Ball& value, Arf& end) {
        const int sign = arf_sgn(end.get());
        if (sign == 0) return; // 0
        arf_abs(end.get(), end.get());
        arb_set_arf(value.get(), end.get());
        arb_root_ui(value.get(), value.get(), 3, precision);
        if (sign < 0) arb_neg(value.get(), value.get());
    });
}

template<void (*function)(arb_t, const arb_t, slong)>
void by_arb(Ball& to, const Ball& a, slong precision) {
    function(to.get(), a.get(), precision);
}
constexpr auto exp = by_arb<arb_exp>, log = by_arb<arb_log>, sin = by_arb<arb_sin>,
               cos = by_arb<arb_cos>, tan = by_arb<arb_tan>, sinh = by_arb<arb_sinh>,
               cosh = by_arb<arb_cosh>, tanh = by_arb<arb_tanh>, atan = by_arb<arb_atan>,
               floor = by_arb<arb_floor>, asinh = by_arb<arb_asinh>, erf = by_arb<arb_hypgeom_erf>;

template<void (*function)(arb_t, const arb_t, const arb_t, slong)>
void of_two_by_arb(Ball& to, const Ball& a, const Ball& b, slong precision) {
    function(to.get(), a.get(), b.get(), precision);
}
constexpr auto add = of_two_by_arb<arb_add>, subtract = of_two_by_arb<arb_sub>,
               divide = of_two_by_arb<arb_div>, min = of_two_by_arb<arb_min>,
               max = of_two_by_arb<arb_max>, atan2 = of_two_by_arb<arb_atan2>;

void multiply(Ball& to, const Ball& a, const Ball& b, slong precision) {
    if (&a == &b) {
        arb_sqr(to.get(), a.get(), precision);
    } else {
        arb_mul(to.get(), a.get(), b.get(), precision);
    }
}

// Across the cut, from below pi to above it.
void angle(Ball& to, const Ball& a, const Ball& b, slong precision) {
    if (!arb_is_negative(b.get()) || !arb_contains_zero(a.get())) {
        arb_atan2(to.get(), a.get(), b.get(), precision);
        return;
    }
    Ball half_turn, ratio;
    arb_const_pi(half_turn.get(), precision);
    arb_div(ratio.get(), a.get(), b.get(), precision);
    arb_atan(ratio.get(), ratio.get(), precision);
    arb_add(to.get(), half_turn.get(), ratio.get(), precision);
}

void power(Ball& to, const Ball& a, const Ball& b, slong precision) {
    const bool integer = arb_is_int(b.get());
    const bool whole = integer && arb_is_nonnegative(b.get());
    if (whole || arb_is_positive(a.get())) {
        arb_pow(to.get(), a.get(), b.get(), precision);
    } else if (arb_is_zero(a.get()) && arb_is_positive(b.get())) {
        arb_zero(to.get());
    } else if (integer && arb_is_negative(a.get())) {
        arb_pow(to.get(), a.get(), b.get(), precision);
    } else if (!integer && arb_is_positive(b.get()) && arb_contains_nonnegative(a.get())) {
        // Rises from 0^b = 0 to the power of a's upper end.
        Arf low, high;
        arb_get_interval_arf(low.get(), high.get(), a.get(), precision);
        Ball largest;
        arb_set_arf(largest.get(), high.get());
        if (arb_is_positive(largest.get())) {
            arb_pow(largest.get(), largest.get(), b.get(), precision);
        }
        const Ball zero;
        arb_union(to.get(), zero.get(), largest.get(), precision);
    } else {
        arb_indeterminate(to.get());
    }
}

} // namespace functions

void select(Ball& to, const Ball& a, const Ball& b, const Ball& then, const Ball& otherwise,
            slong precision) {
    if (arb_lt(a.get(), b.get())) {
        to = then;
    } else if (arb_ge(a.get(), b.get())) {
        to = otherwise;
    } else {
        arb_union(to.get(), then.get(), otherwise.get(), precision);
    }
}

// The derivative of T_degree at x, by the three-term recurrence differentiated `order` times:
// T_n+1^(k) = 2x T_n^(k) + 2k T_n^(k-1) - T_n-1^(k).
Ball chebyshev_derivative(int degree, int order, const Ball& x, slong precision) {
    const std::size_t orders = std::size_t(order) + 1;
    std::vector<Ball> before(orders), now(orders); // T_0 and T_1 to begin with
    arb_one(before[0].get());
    if (degree == 0) return before[std::size_t(order)];
    now[0] = x;
    if (order > 0) arb_one(now[1].get());
    for (int n = 1; n < degree; ++n) {
        for (std::size_t k = orders; k-- > 0;) { // before[k] becomes T_n+1^(k)
            arb_neg(before[k].get(), before[k].get());
            Ball term;
            arb_mul(term.get(), x.get(), now[k].get(), precision);
            if (k > 0) arb_addmul_ui(term.get(), now[k - 1].get(), k, precision);
            arb_addmul_ui(before[k].get(), term.get(), 2, precision);
        }
        std::swap(before, now);
    }
    return now[std::size_t(order)];
}

// On [-c, c], c >= 1, every derivative of T_n is largest at c: so much for how far the value at a's
// midpoint is off, and for the value itself.
void chebyshev(Ball& to, int degree, int order, const Ball& a, slong precision) {
    if (!a.is_finite()) {
        arb_indeterminate(to.get());
        return;
    }
    Ball middle;
    arb_get_mid_arb(middle.get(), a.get());
    Ball value = chebyshev_derivative(degree, order, middle, precision);
    if (arb_is_exact(a.get())) {
        to = std::move(value);
        return;
    }
    Arf reach;
    arb_get_abs_ubound_arf(reach.get(), a.get(), precision);
    if (arf_cmp_si(reach.get(), 1) < 0) arf_one(reach.get());
    Ball c;
    arb_set_arf(c.get(), reach.get());
    Ball radius;
    arb_get_rad_arb(radius.get(), a.get());
    arb_mul(radius.get(), radius.get(), chebyshev_derivative(degree, order + 1, c, precision).get(),
            precision);
    arb_add_error(value.get(), radius.get());
    Ball largest;
    arb_add_error(largest.get(), chebyshev_derivative(degree, order, c, precision).get());
    if (!arb_intersection(to.get(), value.get(), largest.get(), precision)) {
        throw std::logic_error("two enclosures of a Chebyshev polynomial don't meet");
    }
}

void random(Ball& to, std::uint64_t seed, const Ball& i, const Ball& k) {
    if (arb_is_exact(i.get()) && arb_is_exact(k.get())) {
        to = Ball(formula::random_unit(seed, arf_get_d(arb_midref(i.get()), ARF_RND_NEAR),
                                       arf_get_d(arb_midref(k.get()), ARF_RND_NEAR)));
    } else {
        to = Ball(0, 1);
    }
}

std::size_t matching_end(const std::vector<Instruction>& code, std::size_t begin) {
    int depth = 0;
    for (std::size_t at = begin;; ++at) {
        if (code[at].kind == Instruction::Kind::loop_begin) ++depth;
        if (code[at].kind == Instruction::Kind::loop_end && --depth == 0) return at;
    }
}

} // namespace

void BallProgram::evaluate(const formula::Bindings<double>& bindings, std::span<const Ball> inputs,
                           std::span<Ball> outputs, slong precision) {
    const auto& code = program_->instructions;
    std::vector<Loop> loops;
    for (std::size_t at = 0; at < code.size(); ++at) {
        const Instruction& now = code[at];
        switch (now.kind) {
        case Instruction::Kind::begin:
            begin(now);
            break;
        case Instruction::Kind::accumulate:
            accumulate(now, loops.back().element, precision);
            break;
        case Instruction::Kind::loop_begin:
            if (bindings.arrays[std::size_t(now.index)].count > 0) {
                loops.push_back({at, now.index, 0});
            } else {
                at = matching_end(code, at);
            }
            break;
        case Instruction::Kind::loop_end:
            if (++loops.back().element < bindings.arrays[std::size_t(loops.back().array)].count) {
                at = loops.back().begin;
            } else {
                loops.pop_back();
            }
            break;
        case Instruction::Kind::operation:
            operation(now, bindings, inputs, loops, precision);
            break;
        }
    }
    for (std::size_t o = 0; o < outputs.size(); ++o) {
        outputs[o] = registers_[std::size_t(program_->outputs[o])];
    }
}

void BallProgram::begin(const Instruction& now) {
    Ball least_of_none;
    arb_pos_inf(least_of_none.get());
    registers_[std::size_t(now.result)] = now.op == Op::least ? least_of_none : Ball();
    if (formula::keeps_least(now.op)) registers_[std::size_t(now.operands[2])] = least_of_none;
}

void BallProgram::accumulate(const Instruction& now, int element, slong precision) {
    Ball& ball = registers_[std::size_t(now.result)];
    const Ball& a = registers_[std::size_t(now.operands[0])];
    if (now.op == Op::sum) {
        arb_add(ball.get(), ball.get(), a.get(), precision);
    } else if (now.op == Op::least) {
        arb_min(ball.get(), ball.get(), a.get(), precision);
    } else {
        Ball& least = registers_[std::size_t(now.operands[2])];
        const Ball value =
            now.op == Op::pick ? registers_[std::size_t(now.operands[1])] : Ball(element + 1.0);
        select(ball, a, least, value, Ball(ball), precision);
        arb_min(least.get(), least.get(), a.get(), precision);
    }
}

void BallProgram::operation(const Instruction& now, const formula::Bindings<double>& bindings,
                            std::span<const Ball> inputs, const std::vector<Loop>& loops,
                            slong precision) {
    Ball& ball = registers_[std::size_t(now.result)];
    const auto operand = [&](int k) -> const Ball& {
        return registers_[std::size_t(now.operands[std::size_t(k)])];
    };
    const arb_ptr to = ball.get();
    switch (now.op) {
    case Op::constant:
        arb_set_d(to, now.value);
        break;
    case Op::input:
        ball = inputs[std::size_t(now.index)];
        break;
    case Op::parameter:
        arb_set_d(to, bindings.parameters[std::size_t(now.index)]);
        break;
    case Op::element: {
        const auto loop = std::find_if(loops.begin(), loops.end(),
                                       [&](const Loop& l) { return l.array == now.index; });
        const auto& fields = bindings.arrays[std::size_t(now.index)].fields;
        arb_set_d(to, fields[std::size_t(now.second)][std::size_t(loop->element)]);
        break;
    }
    case Op::negate:
        arb_neg(to, operand(0).get());
        break;
#define ROW(name, ...)                                                                             \
    case Op::name:                                                                                 \
        functions::name(ball, operand(0), precision);                                              \
        break;
        ISOMOTION_FUNCTIONS(ROW)
#undef ROW
#define ROW(name, ...)                                                                             \
    case Op::name:                                                                                 \
        functions::name(ball, operand(0), operand(1), precision);                                  \
        break;
        ISOMOTION_OPERATIONS_OF_TWO(ROW)
#undef ROW
    case Op::random:
        random(ball, bindings.seed, operand(0), operand(1));
        break;
    case Op::noise:
        ball = noise({operand(0), operand(1), operand(2)}, formula::NoiseOrder::unpacked(now.index),
                     precision);
        break;
    case Op::chebyshev:
        chebyshev(ball, now.index, now.second, operand(0), precision);
        break;
    case Op::select:
        select(ball, operand(0), operand(1), operand(2), operand(3), precision);
        break;
    case Op::sum:
    case Op::least:
    case Op::pick:
    case Op::which:
        throw std::logic_error("what goes through elements is scheduled as a loop");
    case Op::at:
        throw std::logic_error("what is taken at another point is put in its place by a call");
    }
}

} // namespace isomotion::ball
