// Finds the size of a field's sums where the field is 0.
//
// A root of F = level - S is where S equals the level, so terms that are small compared with the
// level may be left out of S. This is found for any expression of sums, by intervals: F without its
// sums' terms, with a number for each sum. The least element's key is treated as a sum.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "elements/quadric.h"
#include "formula/field.h"

namespace isomotion::elements {

class SumsAtRoots {
public:
    // Considers the sums over `array`; the field's other arrays are summed completely.
    SumsAtRoots(const formula::Field& field, int array);

    // The largest s such that no place of the region is a root if each sum is in s times its unit;
    // 0 if there is none.
    double least(const formula::Bindings<float>& bindings, const Region& region,
                 std::span<const formula::Interval> units) const;
    // Whether F has no root in the region if the sums have these bounds.
    bool exclude(const formula::Bindings<float>& bindings, const Region& region,
                 std::span<const formula::Interval> sums) const;

    // For sums that may be arbitrarily small at roots, as in z - S: the change of the sums, in
    // their units, that moves the roots by as much as they are wide, or equals the whole sum there;
    // the least of these at some places. 0 if no root is found. This is not a bound, but the terms
    // left out by it are bounded.
    double sensitivity(const formula::Bindings<float>& bindings, const Region& region,
                       std::span<const formula::Interval> units) const;

    // Whether F reads the place other than through these sums.
    bool depend_on_place() const { return depend_on_place_; }
    // The number of terms of other arrays that F sums in each evaluation.
    double terms_of_others(const formula::Bindings<float>& bindings) const;

    // Finds roots in boxes in which the sums are bounded. Use one per thread.
    class Boxes {
    public:
        Boxes(const SumsAtRoots& of, const formula::Bindings<float>& bindings);

        // x, y, z and `sums` of each box, all of equal length. Sets excluded[k] if box k has no
        // root.
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
    formula::Program numbers_; // the same inputs -> F, in numbers
};

} // namespace isomotion::elements
