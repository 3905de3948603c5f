#include "scene/srgb.h"

#include <algorithm>
#include <cmath>

namespace isomotion::scene {

double to_linear(double srgb) {
    const double s = std::clamp(srgb, 0.0, 1.0);
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

glm::dvec3 to_linear(const glm::dvec3& srgb) {
    return {to_linear(srgb.x), to_linear(srgb.y), to_linear(srgb.z)};
}

} // namespace isomotion::scene
