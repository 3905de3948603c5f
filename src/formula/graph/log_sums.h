// Logarithms of sums of exponentials, as of bodies that are blended by log(exp(-k*a) + exp(-k*b)).
#pragma once

#include <vector>

#include "formula/graph/term.h"

namespace isomotion::formula {

// log(sum): of p*exp(u) + q*exp(v), where p and q are constants other than 0, it is m + log(p*exp(u
// - m) + q*exp(v - m)), where m is the larger of u and v. Exponentials alone are 0 below exp(-87)
// in float32 and cut off at exp(69).
class LogOfSum {
public:
    explicit LogOfSum(Term sum) { add_terms(sum, 1); }

    // Whether there are exponentials, and factors that are never 0: the largest exponential counts
    // then.
    bool has_largest() const;

    // The largest exponent, cut off where floats are, so that no infinite one is subtracted from
    // itself.
    Term largest() const;

    // The logarithm, where `m` stands for the largest exponent.
    Term value(Term m) const;

private:
    // factor * exp(exponent)
    struct Exponential {
        Term factor;
        Term exponent;
        bool is_one = true; // otherwise the factor is the entire expression and the exponent 0
    };

    // Adds `sign` times the terms of a.
    void add_terms(Term a, double sign);
    Exponential exponential(Term a);

    std::vector<Exponential> terms_;
    // Nodes may be shared, so that paths are many more: beyond some a part is not looked into.
    int left_ = 256;
};

// Whether there is a logarithm of exponentials that are summed over elements. Such a sum stays as
// it is, so it may come to 0 in floats, where its logarithm jumps from -87 to where it is cut off.
bool has_fading_logs(const Graph& graph, NodeId root);

} // namespace isomotion::formula
