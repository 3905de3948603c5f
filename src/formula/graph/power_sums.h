// Powers of sums of powers, as norms are: (abs(x)^n + abs(y)^n)^(1/n).
#pragma once

#include <optional>
#include <vector>

#include "formula/graph/purpose.h"
#include "formula/graph/term.h"

namespace isomotion::formula {

// sum^q: of c*u^p + d*v^p, where c and d are constants above 0, it is m^(p*q) * (c*(u/m)^p +
// d*(v/m)^p)^q, where m is the larger of |u| and |v|. The powers alone are 0 in float32 where |u|
// is below 10^(-38/p), 0.23 for p = 60. For an exponent below 0, m is the smaller one. Bounds know
// that no power of a part is above 1, and that the sum is at least the smaller of c and d.
class PowerOfSum {
public:
    PowerOfSum(Term sum, Term q);

    // Whether all terms are powers with one exponent, which is steep or changes, and none is below
    // 0; and whether q takes most of that exponent back.
    bool has_largest() const;

    // The largest base. Bounds take it as it is. Other purposes divide by it, so it is at least
    // 1e-18 there; numbers multiply it, too, so its power stays below the cut-off of floats.
    Term largest(Purpose purpose) const;

    // The power, where `m` stands for the largest base.
    Term value(Term m, Purpose purpose) const;

    // The power as it is written, if its parts are cut off (Graph::reach()), without that.
    std::optional<Term> without_cut_offs() const;

private:
    // A number and the constants that it is the product of, which may be rounded.
    struct Factor {
        Term exact;
        double number;
    };
    // factor * base^p
    struct Power {
        Factor factor;
        Term base;
    };

    // Adds `factor` times the terms of a.
    void add_terms(Term a, const Factor& factor);
    void add_power(const Factor& factor, Term base, Term exponent);
    // All terms, constants among them.
    std::vector<Power> terms(Purpose purpose) const;

    Term q_;
    Term p_; // of all powers
    std::vector<Power> powers_;
    std::vector<Factor> constants_;
    bool is_sum_of_powers_ = true;
    int left_ = 256; // as in LogOfSum
};

// An expression whose norms are not cut off: what is drawn and proved divides by the largest base,
// so no part overflows. Norms in sums over elements stay as they are.
NodeId norms_without_cut_offs(Graph& graph, NodeId root);

} // namespace isomotion::formula
