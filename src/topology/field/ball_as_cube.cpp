#include "topology/field/ball_as_cube.h"

#include "formula/interval/interval_operations.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

// p; each square occurs in products and sums of what rises with it, so that ends are exact but for
// rounding.
Interval under_root(const SpaceBox& squares) {
    const auto& [a, b, c] = squares;
    return Interval(1) + a * b + c * (Interval(1) - (Interval(1) - a) * (Interval(1) - b));
}

Interval root_of(Interval p) { return formula::Operations<Interval>::sqrt(p); }

SpaceBox squares_of(const SpaceBox& y) { return {square(y[0]), square(y[1]), square(y[2])}; }

// y_k / sqrt(p) at an end of y_k. It rises with y_k; its size falls as the other squares grow.
Interval end(const SpaceBox& squares, std::size_t k, double y, bool is_near) {
    SpaceBox at;
    for (std::size_t i = 0; i < 3; ++i) at[i] = is_near ? squares[i].lo : squares[i].hi;
    at[k] = square(Interval(y));
    return Interval(y) / root_of(under_root(at));
}

} // namespace

BallAsCube::BallAsCube(const scene::BoundsAt& ball)
    : centre_{ball.centre[0], ball.centre[1], ball.centre[2]}
    , radius_(ball.radius) {}

scene::BoundsAt BallAsCube::cube() {
    scene::BoundsAt bounds;
    bounds.shape = scene::Bounds::Shape::box;
    return bounds;
}

SpaceBox BallAsCube::place(const SpaceBox& y) const {
    const SpaceBox squares = squares_of(y);
    SpaceBox made;
    for (std::size_t k = 0; k < 3; ++k) {
        const Interval part{end(squares, k, y[k].lo, y[k].lo < 0).lo,
                            end(squares, k, y[k].hi, y[k].hi > 0).hi};
        made[k] = Interval(centre_[k]) + Interval(radius_) * part;
    }
    return made;
}

BallAsCube::Slopes::Slopes(const SpaceBox& y, double radius)
    : radius_(radius)
    , y_(y) {
    const SpaceBox squares = squares_of(y);
    const Interval q = Interval(1) / root_of(under_root(squares));
    const Interval cubed = q * square(q), fifth = cubed * square(q);
    // dp/dy_k = 2 y_k m_k; m_k doesn't depend on y_k.
    SpaceBox halves;
    for (std::size_t k = 0; k < 3; ++k) {
        const Interval one = squares[(k + 1) % 3], other = squares[(k + 2) % 3];
        const Interval m = Interval(1) - (Interval(1) - one) * (Interval(1) - other);
        halves[k] = y[k] * m;
        first_[k] = -(halves[k] * cubed);
        second_[k][k] = Interval(3) * fifth * square(halves[k]) - cubed * m;
        place_by_y_[k][k] = radius_ * (cubed * (Interval(1) + one * other));
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        const Interval mixed = Interval(2) * y[i] * y[j] * (Interval(1) - squares[k]);
        second_[i][j] = second_[j][i] = Interval(3) * fifth * halves[i] * halves[j] - cubed * mixed;
        place_by_y_[i][j] = radius_ * (y[i] * first_[j]);
        place_by_y_[j][i] = radius_ * (y[j] * first_[i]);
    }
}

SpaceBox BallAsCube::Slopes::gradient(const SpaceBox& in_space) const {
    SpaceBox made;
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t j = 0; j < 3; ++j) made[k] = made[k] + in_space[j] * place_by_y_[j][k];
    }
    return made;
}

SpaceHessian BallAsCube::Slopes::hessian(const SpaceBox& gradient_in_space,
                                         const SpaceHessian& in_space) const {
    const SpaceBox& g = gradient_in_space;
    // Place j has the second derivatives r (d_jk q_l + d_jl q_k + y_j q_kl), with q = p^(-1/2).
    const Interval along = y_[0] * g[0] + y_[1] * g[1] + y_[2] * g[2];
    SpaceHessian turned; // by a place, then by y
    for (std::size_t i = 0; i < 3; ++i) turned[i] = gradient(in_space[i]);
    SpaceHessian made;
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t l = k; l < 3; ++l) {
            Interval sum = radius_ * (g[k] * first_[l] + g[l] * first_[k] + along * second_[k][l]);
            for (std::size_t i = 0; i < 3; ++i) sum = sum + place_by_y_[i][k] * turned[i][l];
            made[k][l] = made[l][k] = sum;
        }
    }
    return made;
}

} // namespace isomotion::topology
