// All that a formula may come out as on a machine with floats: the bound GPU results are held to.
//
// The program runs in interval arithmetic on doubles, and after each operation the range grows by
// what a GPU may be off there. In units of 2^-24, the rounding of a float:
//   - a product or quotient by 1 of its size;
//   - a sum by 4 of the sizes of its terms: rounding is 1 of its own size at most, but without
//     `precise` a driver may add in another order, where each small term meets the large one;
//   - neither where the numbers have so few digits that no order loses one;
//   - a kernel of shaders/math/ by what the tests of the kernels allow it;
//   - what is too small for a normal float may be 0, what is too large infinite.
// Comparisons that the ranges leave open take both sides. So a result outside of its range is a
// mistake and no bad luck, whatever the formula does to errors on the way.
#pragma once

#include <span>
#include <vector>

#include "formula/evaluate/evaluate.h"

namespace isomotion::shader {

struct Range {
    double low = 0, high = 0;
    bool nan = false; // may also be NaN: infinity - infinity, 0/0 and the like

    bool contains(double value) const { return low <= value && value <= high; }
};

struct FloatRanges {
    std::vector<Range> outputs;
    // Some number on the way reached the size at which float kernels saturate: there doubles, which
    // saturate later, go on with another.
    bool saturated = false;
    // A product or an input on the way is so large that a driver, multiplying in another order, may
    // leave the floats: infinity, and NaN after it, are no mistake there.
    bool strained = false;
};

FloatRanges float_ranges(const formula::Program& program, const formula::Bindings<double>& bindings,
                         std::span<const double> inputs);

} // namespace isomotion::shader
