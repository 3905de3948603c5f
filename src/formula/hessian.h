// Second derivatives of a field, made where something asks for them: most scenes never do.
#pragma once

#include <string>

#include "formula/field.h"

namespace isomotion::formula {

// Inputs x y z -> F_xx, F_xy, F_xz, F_yy, F_yz, F_zz, by rules as the gradient is: where F has a
// kink they are those of the side that the gradient is of.
Program hessian(const Field& field);

// struct Hessian { float xx, xy, xz, yy, yz, zz; }; Hessian field_hessian(vec3 p)
std::string glsl_hessian(const Program& hessian, const ArrayPacking& packing);

} // namespace isomotion::formula
