// How large a field's sums are where it is 0.
//
// A root of F = level - S is where S is the level: what is small beside that may be left out of S.
// Found for any expression of sums, by intervals: F without its sums' terms, with a number for
// each sum. The least element's key counts as one.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "elements/quadric.h"
#include "formula/field.h"

namespace isomotion::elements {

class SumsAtRoots {
public:
    // Looks at the sums over `array`; the field's other arrays are summed as they are.
    SumsAtRoots(const formula::Field& field, int array);

    // The largest s such that no place of the region is a root where all sums are in s times their
    // units; 0 if there is none.
    double least(const formula::Bindings<float>& bindings, const Region& region,
                 std::span<const formula::Interval> units) const;
    // Whether F has no root in the region with these bounds of the sums.
    bool exclude(const formula::Bindings<float>& bindings, const Region& region,
                 std::span<const formula::Interval> sums) const;

    // Where sums are as small as one likes at roots, as of z - S: how much of them, in their units,
    // moves the roots by as much as they are wide, or is all that a sum is there; the least of it
    // at some places. 0 if no root is found. No bound, but what is left out by it has one.
    double sensitivity(const formula::Bindings<float>& bindings, const Region& region,
                       std::span<const formula::Interval> units) const;

    // Whether F reads the place other than through these sums.
    bool depend_on_place() const { return depend_on_place_; }
    // How many terms F sums besides, of other arrays, each time that it is asked for.
    double terms_of_others(const formula::Bindings<float>& bindings) const;

    // Looks for roots in boxes, where sums have bounds. One a thread.
    class Boxes {
    public:
        Boxes(const SumsAtRoots& of, const formula::Bindings<float>& bindings);

        // Boxes x, y, z and `sums` of each box, as many: excluded[k] is whether there is no root.
        void exclude(std::span<const std::vector<formula::Interval>> places_and_sums,
                     std::vector<bool>& excluded);

    private:
        formula::Evaluator<formula::Interval> evaluator_;
        formula::Bindings<formula::Interval> bindings_;
        std::vector<formula::Interval> values_, gaps_;
    };

private:
    friend class Boxes;

    bool exclude(Boxes& boxes, const Region& region, std::span<const formula::Interval> sums) const;

    int array_;
    int sums_ = 0;
    bool depend_on_place_ = false;
    formula::Program field_;   // inputs: x y z, the value of each sum -> F, without_value()
    formula::Program numbers_; // the same inputs -> F, of numbers
};

} // namespace isomotion::elements
