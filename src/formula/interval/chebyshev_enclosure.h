// The range of a Chebyshev polynomial, or of a derivative of one, over an interval.
//
// T_n^(k) is monotone between its extrema, of which n-k-1 lie in (-1, 1) and none outside. So its
// range is the hull of the values at the interval's ends and of the extrema inside it, and the
// enclosure is exact up to rounding. Products of intervals lose a little each, and at degree 50
// would have lost everything.
//
// Values come from T_2m = 2 T_m^2 - 1 and T_2m+1 = 2 T_m T_m+1 - x, which take log2(n) steps. They
// are computed with Taylor series about x, which propagate the derivatives, in DoubleDouble
// numbers, which propagate their error. Extrema of T_n are the points cos(j pi/n). Those of T_n^(k)
// lie between those of T_n^(k-1); they are isolated once, by bisection with certain signs.
#pragma once

#include <vector>

#include "formula/interval/double_double.h"
#include "formula/interval/interval.h"

namespace isomotion::formula {

class ChebyshevEnclosure {
public:
    // Derivatives above the 6th are bounded by their largest value on [-1, 1], and by the entire
    // line outside. Construction takes 2 ms for the slope of T_50.
    ChebyshevEnclosure(int degree, int derivative);

    Interval operator()(Interval a) const;

private:
    struct Extremum {
        Interval where, value;
    };

    Interval at(double x) const;
    Interval at_ends(Interval a) const; // the hull of both values
    Interval bounded(double x, DoubleDouble<double> value) const;

    int degree_, derivative_;
    Interval at_one_, bound_; // the value at 1, and the bound on [-1, 1]
    double reach_;            // where values are held constant, or come near the end of doubles
    std::vector<Extremum> extrema_; // ascending
};

} // namespace isomotion::formula
