// Colours as other programs write them.
#pragma once

#include <glm/vec3.hpp>

namespace isomotion::scene {

// Converts an sRGB component, from 0 to 1, or all three.
double to_linear(double srgb);
glm::dvec3 to_linear(const glm::dvec3& srgb);

} // namespace isomotion::scene
