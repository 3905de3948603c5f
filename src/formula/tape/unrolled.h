// Programs with their loops over elements written out, for interpreters that have none.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "formula/evaluate/evaluate.h"
#include "formula/glsl/glsl.h"
#include "formula/graph/program.h"

namespace isomotion::formula {

// How many elements an array has, over all times.
struct ElementRange {
    int least = 0, most = 0;
};

// Where a program without loops reads elements: from parameters behind the formula's own. Each
// array has the number of its elements there, and then a column for each field of the packing.
class ElementParameters {
public:
    // `parameters`: of the formula itself.
    ElementParameters(int parameters, ArrayPacking packing, std::vector<ElementRange> ranges);

    const ElementRange& range(int array) const { return ranges_[std::size_t(array)]; }
    int count(int array) const { return first_[std::size_t(array)]; }
    int field(int array, int field, int element) const;

    // The formula's parameters and those of elements, in their order.
    std::vector<float> values(const Bindings<float>& bindings) const;

private:
    int parameters_;
    ArrayPacking packing_;
    std::vector<ElementRange> ranges_;
    std::vector<int> first_; // of each array's parameters
};

// The program without loops, with the same values for all numbers of elements in the ranges. None
// if writing out its loops makes it longer than so many instructions; one without loops stays as it
// is.
std::optional<Program> unrolled(const Program& program, const ElementParameters& elements,
                                std::size_t longest);

} // namespace isomotion::formula
