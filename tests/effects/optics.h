// What tests of glass see it before, and Fresnel's equations.
#pragma once

#include <cmath>

#include <glm/glm.hpp>

#include "render/renderer.h"

namespace isomotion::render {

// The sky's red is a half plus a half of the direction's z, its green is 1, its blue 0.5.
inline constexpr const char* sky_by_height =
    "background = { top = [1, 1, 0.5], bottom = [0, 1, 0.5] }\n";
inline glm::dvec3 sky(const glm::dvec3& d) { return {0.5 + 0.5 * d.z, 1, 0.5}; }
inline constexpr const char* white = "background = [1, 1, 1]\n";
inline constexpr const char* dark = "[[lights]]\ndirection = [0, 0, 1]\ncolor = [0, 0, 0]\n";

inline glm::dvec3 color(const Picture& picture, std::size_t pixel) {
    glm::dvec3 found;
    for (int k = 0; k < 3; ++k) found[k] = picture.frame.channels[std::size_t(k)].samples[pixel];
    return found;
}

// The part of unpolarised light that is reflected, by both angles: n1 sin a = n2 sin b.
inline double fresnel(double a, double n1, double n2) {
    const double sine = n1 / n2 * std::sin(a);
    if (sine >= 1) return 1;
    const double b = std::asin(sine);
    if (a < 1e-7) return std::pow((n1 - n2) / (n1 + n2), 2);
    const double s = std::sin(a - b) / std::sin(a + b), p = std::tan(a - b) / std::tan(a + b);
    return 0.5 * (s * s + p * p);
}

} // namespace isomotion::render
