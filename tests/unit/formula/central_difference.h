// Derivatives by differences, the oracle for those by rules.
#pragma once

#include <cmath>
#include <limits>

namespace isomotion::formula {

// How far `claimed` is from the slope of f at 0, as a fraction of its size and of that of f. The
// step that balances truncation against rounding depends on f, so the best of several counts: no
// step makes a wrong derivative right.
template<class F> double slope_error(F&& f, double claimed, double unit = 1) {
    double best = std::numeric_limits<double>::infinity();
    for (const double fraction : {3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4}) {
        const double h = fraction * unit;
        const double near = f(h) - f(-h), far = f(2 * h) - f(-2 * h);
        const double slope = (8 * near - far) / (12 * h);
        const double size = 1 + std::abs(claimed) + std::abs(f(0));
        const double error = std::abs(slope - claimed) / size;
        if (error < best) best = error; // false for NaN
    }
    return best;
}

} // namespace isomotion::formula
