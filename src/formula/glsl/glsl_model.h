// Writes a Program as GLSL on models: F about the middle of a piece, as a polynomial of second
// degree with a bound on the remainder (Taylor models: Makino & Berz 2003, Reliable Computing 9).
//
// A model may be of one ray's piece, of a block's piece or of a point. The file of shaders/proof/
// that defines its type and the functions md_... on it decides this.
#pragma once

#include <string>

#include "formula/glsl/glsl_interval.h"

namespace isomotion::formula {

// The degree of a polynomial in x, y and z that can have models: its program is short, only adds
// and multiplies, and has no loop over an array. Chebyshev polynomials that are written by angles
// (graph/chebyshev_form.h) count as polynomials. 0 for other fields.
int modelled_degree(const Field& field);

// Model field_model(Model x, Model y, Model z), where Model is `type`, for a field with models.
// Constants that this number type cannot represent are given with their rounding error.
std::string glsl_value_model(const Field& field, const std::string& type,
                             Numbers numbers = Numbers::floats);

} // namespace isomotion::formula
