// The equations of a critical point: F = 0 and dF/dx_i = 0 for the d free coordinates x_i. They are
// n = d + 1 equations in as many variables, the coordinates and the clock.
#pragma once

#include "topology/field/moving_field.h"
#include "topology/search/krawczyk.h"

namespace isomotion::topology {

// The sign that all members have; 0 if they have none in common.
inline int sign_of(const formula::Interval& a) { return a.lo > 0 ? 1 : a.hi < 0 ? -1 : 0; }

// The left-hand sides.
template<class T> std::array<T, most_variables> residual(const Jet<T>& jet, std::size_t n) {
    std::array<T, most_variables> f{};
    f[0] = jet.value;
    for (std::size_t i = 0; i + 1 < n; ++i) f[1 + i] = jet.gradient[i];
    return f;
}

// Their derivatives, one row per equation.
template<class T>
std::array<std::array<T, most_variables>, most_variables> jacobian(const Jet<T>& jet,
                                                                   std::size_t n) {
    std::array<std::array<T, most_variables>, most_variables> rows{};
    for (std::size_t k = 0; k < n; ++k) {
        rows[0][k] = jet.gradient[k];
        for (std::size_t i = 0; i + 1 < n; ++i) rows[1 + i][k] = jet.hessian[i][k];
    }
    return rows;
}

// The step that Newton's method subtracts from the variables. Empty if the Jacobian is nearly
// singular.
inline std::optional<Point> newton_step(const Jet<double>& jet, std::size_t n) {
    const auto y = inverse(jacobian(jet, n), int(n));
    if (!y) return std::nullopt;
    const Point f = residual(jet, n);
    Point step{};
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) step[i] += (*y)[i][j] * f[j];
    }
    return step;
}

} // namespace isomotion::topology
