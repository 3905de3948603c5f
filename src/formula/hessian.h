// Second derivatives of a field. They are made only where needed; most scenes never need them.
#pragma once

#include <string>

#include "formula/field.h"

namespace isomotion::formula {

// Inputs x y z -> F_xx, F_xy, F_xz, F_yy, F_yz, F_zz, by the rules of the gradient: at a kink they
// are those of the side that the gradient has.
Program hessian(const Field& field);

// struct Hessian { float xx, xy, xz, yy, yz, zz; }; Hessian field_hessian(vec3 p)
std::string glsl_hessian(const Program& hessian, const ArrayPacking& packing);

} // namespace isomotion::formula
