// How large a field's sums are where it is 0.
//
// A root of F = level - S is where S is the level: what is small beside that may be left out of S.
// Found for any expression of sums, by intervals: F without its sums' terms, with a number for
// each sum.
#pragma once

#include <optional>
#include <span>

#include "elements/quadric.h"
#include "formula/field.h"

namespace isomotion::elements {

class SumsAtRoots {
public:
    // Of the sums over `array`; the field's other arrays are summed as they are.
    SumsAtRoots(const formula::Field& field, int array);

    // The largest s such that no place of the region is a root where all sums are in s times their
    // units; 0 if there is none.
    double least(const formula::Bindings<float>& bindings, const Region& region,
                 std::span<const formula::Interval> units) const;
    // Whether F has no root in the region without elements.
    bool are_everything(const formula::Bindings<float>& bindings, const Region& region) const;

private:
    class Boxes;

    int array_;
    int sums_ = 0;
    formula::Program field_; // inputs: x y z, the value of each sum -> F
};

} // namespace isomotion::elements
