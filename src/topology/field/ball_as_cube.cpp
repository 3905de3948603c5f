#include "topology/field/ball_as_cube.h"

#include <algorithm>
#include <cmath>

namespace isomotion::topology {
namespace {

using formula::Interval;

// What follows is computed in doubles and errs by less than 2^-48 of its size. With u = 2^-53, a
// square errs by u of its size, m by 8 u, p by 17 u and its root's reciprocal by 11 u: in the cube
// none of the terms is below 0, none above 1, and p is at least 1. A little beyond it this holds
// but for a part of 2^-18.
constexpr Interval about_1{1 - 0x1p-48, 1 + 0x1p-48};

// m = 1 - (1 - a)(1 - b).
double rate(double a, double b) { return a + b * (1 - a); }
// Its ends are at corners, since it is linear in each: in the cube it rises with both, but beyond a
// wall it falls.
Interval rate(const Interval& a, const Interval& b) {
    const auto [low, high] =
        std::minmax({rate(a.lo, b.lo), rate(a.lo, b.hi), rate(a.hi, b.lo), rate(a.hi, b.hi)});
    return {low, high};
}
// p rises with each square.
double under_root(double a, double b, double c) { return 1 + a * b + c * rate(a, b); }

// Ends that are computed in doubles, widened by what these err.
Interval widened(const Interval& ends) { return product_not_negative(ends, about_1); }

SpaceBox squares_of(const SpaceBox& y) { return {square(y[0]), square(y[1]), square(y[2])}; }

// y_k / sqrt(p) at an end of y_k. It rises with y_k; its size falls as the other squares grow.
double end(const SpaceBox& squares, std::size_t k, double y, bool is_near) {
    const Interval one = squares[(k + 1) % 3], other = squares[(k + 2) % 3];
    const double p =
        is_near ? under_root(one.lo, other.lo, y * y) : under_root(one.hi, other.hi, y * y);
    return y / std::sqrt(p);
}

} // namespace

BallAsCube::BallAsCube(const scene::BoundsAt& ball)
    : centre_{ball.centre[0], ball.centre[1], ball.centre[2]}
    , radius_(ball.radius)
    , reach_(times_positive(about_1, radius_)) {}

scene::BoundsAt BallAsCube::cube() {
    scene::BoundsAt bounds;
    bounds.shape = scene::Bounds::Shape::box;
    return bounds;
}

SpaceBox BallAsCube::place(const SpaceBox& y) const {
    const SpaceBox squares = squares_of(y);
    SpaceBox made;
    for (std::size_t k = 0; k < 3; ++k) {
        const Interval part{end(squares, k, y[k].lo, y[k].lo < 0),
                            end(squares, k, y[k].hi, y[k].hi > 0)};
        made[k] = Interval(centre_[k]) + times_not_negative(part, reach_);
    }
    return made;
}

BallAsCube::Slopes::Slopes(const SpaceBox& y, double radius)
    : radius_(radius)
    , y_(y)
    , squares_(squares_of(y)) {
    const auto& [a, b, c] = squares_;
    root_ = widened(
        {1 / std::sqrt(under_root(a.hi, b.hi, c.hi)), 1 / std::sqrt(under_root(a.lo, b.lo, c.lo))});
    cubed_ = product_not_negative(root_, product_not_negative(root_, root_));
    for (std::size_t k = 0; k < 3; ++k) {
        const Interval one = squares_[(k + 1) % 3], other = squares_[(k + 2) % 3];
        rates_[k] = widened(rate(one, other));
        halves_[k] = times_not_negative(y[k], rates_[k]);
        first_[k] = -times_not_negative(halves_[k], cubed_);
        place_by_y_[k][k] =
            product_not_negative(cubed_, Interval(1) + product_not_negative(one, other));
    }
    for (std::size_t i = 0; i < 3; ++i) {
        for (const std::size_t j : {(i + 1) % 3, (i + 2) % 3}) place_by_y_[i][j] = y[i] * first_[j];
    }
}

SpaceBox BallAsCube::Slopes::turned(const SpaceBox& in_space) const {
    SpaceBox made;
    for (std::size_t k = 0; k < 3; ++k) {
        made[k] = in_space[0] * place_by_y_[0][k] + in_space[1] * place_by_y_[1][k] +
                  in_space[2] * place_by_y_[2][k];
    }
    return made;
}

SpaceBox BallAsCube::Slopes::gradient(const SpaceBox& in_space) const {
    SpaceBox made = turned(in_space);
    for (Interval& slope : made) slope = times_positive(slope, radius_);
    return made;
}

SpaceHessian BallAsCube::Slopes::hessian(const SpaceBox& gradient_in_space,
                                         const SpaceHessian& in_space) const {
    const SpaceBox &g = gradient_in_space, &y = y_;
    const Interval fifth = product_not_negative(cubed_, product_not_negative(root_, root_));
    SpaceHessian second; // of q
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        const Interval mixed = Interval(2) * y[i] * y[j] * (Interval(1) - squares_[k]);
        second[i][j] = Interval(3) * fifth * halves_[i] * halves_[j] - cubed_ * mixed;
        second[j][i] = second[i][j];
        second[k][k] = Interval(3) * fifth * square(halves_[k]) - cubed_ * rates_[k];
    }
    // Place j has the second derivatives r (d_jk q_l + d_jl q_k + y_j q_kl).
    const Interval along = y[0] * g[0] + y[1] * g[1] + y[2] * g[2];
    SpaceHessian by_both; // by a place, then by y
    for (std::size_t i = 0; i < 3; ++i) by_both[i] = turned(in_space[i]);
    SpaceHessian made;
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t l = k; l < 3; ++l) {
            Interval of_slopes;
            for (std::size_t i = 0; i < 3; ++i)
                of_slopes = of_slopes + place_by_y_[i][k] * by_both[i][l];
            const Interval sum = g[k] * first_[l] + g[l] * first_[k] + along * second[k][l] +
                                 times_positive(of_slopes, radius_);
            made[k][l] = made[l][k] = times_positive(sum, radius_);
        }
    }
    return made;
}

} // namespace isomotion::topology
