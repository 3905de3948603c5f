// Powers of sums of powers, as norms are: (abs(x)^n + abs(y)^n)^(1/n).
#pragma once

#include <optional>
#include <vector>

#include "formula/graph/term.h"

namespace isomotion::formula {

// sum^q: of c*u^p + d*v^p, where c and d are constants above 0, it is m^(p*q) * (c*(u/m)^p +
// d*(v/m)^p)^q, where m is the larger of |u| and |v|. The powers alone are 0 in float32 from |u| =
// 10^(-38/p) on, and cut off beyond 10^(30/p): at 0.23 and 3.2 for p = 60.
class PowerOfSum {
public:
    PowerOfSum(Term sum, Term q);

    // Whether all terms are steep powers with one exponent, and q takes most of that back:
    // constants, or an exponent that changes and its inverse.
    bool has_largest() const;

    // The largest base, so far from 0 that it divides.
    Term largest() const;

    // The power, where `m` stands for the largest base.
    Term value(Term m) const;

private:
    // factor * base^p
    struct Power {
        double factor;
        Term base;
    };

    // Adds `factor` times the terms of a.
    void add_terms(Term a, double factor);
    void add_power(double factor, Term base, Term exponent);

    Term q_;
    std::optional<Term> p_;
    std::vector<Power> terms_;
    std::vector<double> constants_;
    bool is_sum_of_powers_ = true;
    int left_ = 256; // as in LogOfSum
};

} // namespace isomotion::formula
