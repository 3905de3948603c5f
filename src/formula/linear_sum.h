// A field that is one sum over its array and something else: F = c S + R, where neither c nor R
// depends on the sum S.
//
// At a root S is -R/c. That tells how large the sum is where it matters, and so which elements may
// be left out of it there: those whose terms are nothing beside that.
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

// For fields with one array, summed over once; the programs are for intervals, as in enclosure.h.
std::optional<LinearSum> linear_sum(const Field& field);

// void rest_and_factor_interval(vec2 x, vec2 y, vec2 z, out vec2 rest, out vec2 factor); on doubles
// each vec2 stands for a dvec2.
std::string glsl_rest_and_factor_interval(const LinearSum& sum, const ArrayPacking& packing,
                                          Numbers numbers = Numbers::floats);
// vec2 term_interval(int e0, vec2 x, vec2 y, vec2 z)
std::string glsl_term_interval(const LinearSum& sum, const ArrayPacking& packing);

} // namespace isomotion::formula
