// Finds the quadratic polynomials through which the terms of sums depend on the place.
//
// Terms of most sums over elements are kernels of a distance: exp(-a r^2), max(0, 1 - r^2/h^2)^3,
// r^2 = (x - cx)^2 + ..., or |G (x - c)|^2 of an anisotropic kernel. In the graph of such a term
// one polynomial of degree 2 separates the coordinates from everything else. So an element matters
// inside a level set of its polynomial, which is an ellipsoid. The polynomial is found in the
// formula's graph, whatever its names and however it is written. Keys of least(array, key) are
// treated in the same way: an element may be the least inside a level set. Other terms, such as
// those of boxes and capsules, are bounded place by place.
#pragma once

#include <optional>
#include <vector>

#include "formula/field.h"

namespace isomotion::formula {

struct ElementKernels {
    // A quadric is given by its value, gradient and Hessian (xx xy xz yy yz zz) at x = y = z = 0.
    static constexpr int coefficients_each = 10;
    // Limit on sums, since each sum has bounds in each cell of a grid.
    static constexpr std::size_t most_sums = 32;

    int array = 0;
    bool is_least = false;   // one `least` instead of sums; its term is the key
    std::vector<int> fields; // fields of the array that the programs read as inputs
    int quadrics = 0; // number of polynomials; those of several sums count once. 0 if some term
                      // reads the place in another way
    std::vector<int> quadric_of; // of each sum
    Program coefficients;        // inputs: fields -> coefficients_each for each quadric
    // Inputs: x y z, the value of each quadric, fields -> the term of each sum. Terms read x y z
    // only if they depend on the place in other ways than through a quadric.
    Program terms;
    bool read_places = false;
    Program by_place; // inputs: x y z, fields -> the term of each sum

    int first_field() const { return 3 + quadrics; } // input of `terms`
    int sums() const { return int(quadric_of.size()); }
};

// Describes the sums over `array`, or its one `least` if there is no sum. None if there are too
// many sums, if a sum holds another one, or if a term does not fade away from its element.
std::optional<ElementKernels> element_kernels(const Field& field, int array);

} // namespace isomotion::formula
