// From where on it does not matter how much more the least element's key is.
//
// F = min(L, z), L = least(array, key): where L is above 0 F may have roots, those of z, but the
// same ones whatever L is. So an element whose key is above that need not be known. Found for any
// formula that asks for one array's least element, by intervals: F with a number in its place.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "elements/quadric.h"
#include "formula/field.h"

namespace isomotion::elements {

class LeastAtRoots {
public:
    LeastAtRoots(const formula::Field& field, int array);

    // The least such number, as near as halving the range tells; never too small. None if even the
    // range's upper end matters. The array's own elements are not read.
    std::optional<double> enough(const formula::Bindings<float>& bindings, const Region& region,
                                 const formula::Interval& range) const;

private:
    class Search;

    std::size_t array_;
    bool depends_on_place_ = false;
    // Inputs: x y z L -> F and dF/dL, then the same of each part whose signs tell F's: of a and b
    // where F is min(a, b), max(a, b) or a*b.
    formula::Program program_;
};

} // namespace isomotion::elements
