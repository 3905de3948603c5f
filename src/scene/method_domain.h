// Which formulas a method can draw.
#pragma once

#include <string>
#include <vector>

#include "formula/field.h"
#include "scene/method.h"

namespace isomotion::scene {

// The highest degree that the method chebyshev solves. At higher degrees float32 loses too much
// accuracy between samples and coefficients: the largest coefficient of T_n in Bernstein's form is
// about 2^n / sqrt(n).
inline constexpr int highest_solved_degree = 12;

// Empty if the method can draw the formula; otherwise the reason why it can't.
std::string refusal(Method method, const formula::Field& field);

std::vector<Method> methods_for(const formula::Field& field);

// The degree, from 1 to highest_solved_degree. Throws std::invalid_argument with the refusal of
// chebyshev.
int solved_degree(const formula::Field& field);

} // namespace isomotion::scene
