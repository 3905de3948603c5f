// Finds the value above which the least element's key no longer matters.
//
// Example: F = min(L, z), L = least(array, key). Where L is above 0, F may have roots, those of z,
// but they are the same whatever L is. So an element whose key is above that need not be known. The
// value is found by intervals, with a number in place of the least key, for any formula that asks
// for the least element of one array.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "elements/quadric.h"
#include "formula/field.h"

namespace isomotion::elements {

class LeastAtRoots {
public:
    LeastAtRoots(const formula::Field& field, int array);

    // The least such value, to the accuracy of halving the range; never too small. None if even the
    // range's upper end matters. Doesn't read the array's own elements.
    std::optional<double> enough(const formula::Bindings<float>& bindings, const Region& region,
                                 const formula::Interval& range) const;

private:
    class Search;

    std::size_t array_;
    std::array<bool, 3> depends_on_{}; // x, y and z, beside L
    // Inputs: x y z L -> F and dF/dL, then the same for each part whose signs determine F's sign:
    // for a and b where F is min(a, b), max(a, b) or a*b.
    formula::Program program_;
};

} // namespace isomotion::elements
