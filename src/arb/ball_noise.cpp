#include "arb/ball_noise.h"

#include <algorithm>

#include "formula/interval/noise_enclosure.h"

namespace isomotion::ball {
namespace {

// A ball, and the precision of arithmetic with it; numbers that are given take the other's.
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
        constexpr slong of_given = 64; // of small whole numbers: exact
        const slong bits = result.precision > 0 ? result.precision : of_given;
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

// The lower ends of the first and the last cell that a ball meets.
constexpr slong exact_bits = 256;
std::array<double, 2> cells(const Ball& ball) {
    std::array<double, 2> ends{};
    arf_t end;
    arf_init(end);
    arb_get_lbound_arf(end, ball.get(), exact_bits);
    arf_floor(end, end);
    ends[0] = arf_get_d(end, ARF_RND_FLOOR);
    arb_get_ubound_arf(end, ball.get(), exact_bits);
    arf_floor(end, end);
    ends[1] = arf_get_d(end, ARF_RND_FLOOR);
    arf_clear(end);
    return ends;
}

} // namespace

Ball noise(const std::array<Ball, 3>& place, const formula::NoiseOrder& order, slong precision) {
    Ball all;
    if (!std::ranges::all_of(place, [](const Ball& ball) { return ball.is_finite(); })) {
        arb_indeterminate(all.get());
        return all;
    }
    const double bound = formula::noise_bound(order);
    Ball anywhere(-bound, bound);
    std::array<std::array<double, 2>, 3> met;
    std::ranges::transform(place, met.begin(), cells);
    constexpr double most_cells = 3, exact_up_to = 0x1p53;
    for (const auto& [first, last] : met) {
        const bool are_few = last - first < most_cells && std::abs(first) < exact_up_to;
        if (!are_few) return anywhere;
    }
    bool is_first = true;
    for (double k = met[2][0]; k <= met[2][1]; ++k) {
        for (double j = met[1][0]; j <= met[1][1]; ++j) {
            for (double i = met[0][0]; i <= met[0][1]; ++i) {
                const auto within = [&](std::size_t axis, double low) {
                    return Number(place[axis], precision) - Number(low);
                };
                const Number value = formula::lattice::in_cell<Number>(
                    {formula::lattice::point(i), formula::lattice::point(j),
                     formula::lattice::point(k)},
                    {within(0, i), within(1, j), within(2, k)}, order);
                if (is_first) {
                    all = value.ball;
                } else {
                    arb_union(all.get(), all.get(), value.ball.get(), precision);
                }
                is_first = false;
            }
        }
    }
    Ball within_bound;
    return arb_intersection(within_bound.get(), all.get(), anywhere.get(), precision) ? within_bound
                                                                                      : all;
}

} // namespace isomotion::ball
