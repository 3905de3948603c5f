#include "arb/ball_noise.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "formula/interval/noise_enclosure.h"

namespace isomotion::ball {
namespace {

// A ball and the precision of its arithmetic, in bits. Constants take the other operand's.
struct Number {
    Ball ball;
    slong precision = 0;

    Number(double exact = 0)
        : ball(exact) {}
    Number(Ball of, slong bits)
        : ball(std::move(of))
        , precision(bits) {}

    template<void (*operation)(arb_t, const arb_t, const arb_t, slong)>
    Number with(const Number& other) const {
        Number result(Ball(), std::max(precision, other.precision));
        constexpr slong of_constants = 64; // small whole numbers are exact
        const slong bits = result.precision > 0 ? result.precision : of_constants;
        operation(result.ball.get(), ball.get(), other.ball.get(), bits);
        return result;
    }
    friend Number operator+(const Number& a, const Number& b) { return a.with<arb_add>(b); }
    friend Number operator-(const Number& a, const Number& b) { return a.with<arb_sub>(b); }
    friend Number operator*(const Number& a, const Number& b) { return a.with<arb_mul>(b); }
    friend bool operator>(const Number& a, const Number& b) {
        return arb_gt(a.ball.get(), b.ball.get()) != 0;
    }
};

// The part of a ball within another, which it meets.
Ball cut(const Ball& ball, const Ball& by, slong precision) {
    Ball part;
    return arb_intersection(part.get(), ball.get(), by.get(), precision) != 0 ? part : ball;
}

// The cells that balls meet.
formula::lattice::Cells cells_of(const std::array<Ball, 3>& place) {
    constexpr slong exact = 256;
    formula::lattice::Cells cells;
    arf_t end;
    arf_init(end);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        arb_get_lbound_arf(end, place[axis].get(), exact);
        arf_floor(end, end);
        cells.first[axis] = arf_get_d(end, ARF_RND_FLOOR);
        arb_get_ubound_arf(end, place[axis].get(), exact);
        arf_floor(end, end);
        cells.last[axis] = arf_get_d(end, ARF_RND_FLOOR);
    }
    arf_clear(end);
    return cells;
}

} // namespace

Ball noise(const std::array<Ball, 3>& place, const formula::NoiseOrder& order, slong precision) {
    if (!std::ranges::all_of(place, [](const Ball& ball) { return ball.is_finite(); })) {
        Ball none;
        arb_indeterminate(none.get());
        return none;
    }
    const double bound = formula::noise_bound(order);
    const formula::lattice::Cells cells = cells_of(place);
    const Ball anywhere(-bound, bound), unit(0, 1);
    if (!cells.are_few()) return Ball(anywhere);
    std::optional<Ball> all;
    cells.visit([&](const std::array<double, 3>& low) {
        const auto within = [&](std::size_t axis) {
            return cut((Number(place[axis], precision) - Number(low[axis])).ball, unit, precision);
        };
        const std::array<Number, 3> inside{Number(within(0), precision),
                                           Number(within(1), precision),
                                           Number(within(2), precision)};
        const Ball value =
            cut(formula::lattice::in_cell<Number>(low, inside, order).ball, anywhere, precision);
        if (all) {
            arb_union(all->get(), all->get(), value.get(), precision);
        } else {
            all = value;
        }
    });
    return all ? *all : anywhere; // few cells are one at least
}

} // namespace isomotion::ball
