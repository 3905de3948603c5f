// Program -> GLSL on models: F about the middle of a piece, as a polynomial of second degree with
// a bound on all that it leaves out (Taylor models: Makino & Berz 2003, Reliable Computing 9).
//
// What a model is of, of one ray's piece, of a block's or of a point, is told by the file of
// shaders/proof/ that defines its type and the functions md_... on it.
#pragma once

#include <string>

#include "formula/glsl/glsl_interval.h"

namespace isomotion::formula {

// The degree of a polynomial in x, y and z that has models: the program is not long, adds and
// multiplies, and goes through no array. 0 of other fields.
int modelled_degree(const Field& field);

// Model field_model(Model x, Model y, Model z) of the type that is called `type`, of a field with
// models. Constants that are no numbers of this kind are told with their rounding.
std::string glsl_value_model(const Field& field, const std::string& type,
                             Numbers numbers = Numbers::floats);

} // namespace isomotion::formula
