// Fields of the form F = c S + R, where S is the one sum over an array, and neither c nor R depends
// on S.
//
// At a root S is -R/c. This gives the size of the sum where it matters. Elements whose terms are
// negligible relative to that size may be left out there.
#pragma once

#include <optional>
#include <string>

#include "formula/field.h"
#include "formula/glsl/glsl_interval.h"

namespace isomotion::formula {

struct LinearSum {
    static constexpr int array = 0;

    Program rest_and_factor; // R, c
    Program term;            // one element's part of S
};

// For fields with one array and one sum over it. The programs are for intervals, as in enclosure.h.
std::optional<LinearSum> linear_sum(const Field& field);
// Throws std::logic_error for other fields.
LinearSum known_linear_sum(const Field& field);

// void rest_and_factor_interval(vec2 x, vec2 y, vec2 z, out vec2 rest, out vec2 factor); on doubles
// each vec2 stands for a dvec2.
std::string glsl_rest_and_factor_interval(const LinearSum& sum, const ArrayPacking& packing,
                                          Numbers numbers = Numbers::floats);
// vec2 term_interval(int e0, vec2 x, vec2 y, vec2 z)
std::string glsl_term_interval(const LinearSum& sum, const ArrayPacking& packing);

} // namespace isomotion::formula
