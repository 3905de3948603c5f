#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "image/srgb.h"

namespace isomotion::image {

inline std::uint8_t signal(float light, std::uint8_t) { return srgb8().code(light); }
inline std::uint16_t signal(float light, std::uint16_t) {
    return quantised<std::uint16_t>(srgb_from_linear(std::clamp(light, 0.0f, 1.0f)));
}

/// Adds what a file or a screen is given for a pixel: sRGB of the colour divided by coverage, then
/// the coverage where there is one.
template<class Code>
void pack_pixel(const ColourPlanes& planes, std::size_t pixel, std::vector<Code>& out) {
    float scale = 1.0f;
    if (planes.coverage) {
        const float coverage = std::min(planes.coverage[pixel], 1.0f);
        scale = coverage > 0.0f ? 1.0f / coverage : 0.0f;
    }
    for (const float* plane : {planes.red, planes.green, planes.blue})
        out.push_back(signal(scale > 0.0f ? plane[pixel] * scale : 0.0f, Code{}));
    if (planes.coverage) out.push_back(quantised<Code>(planes.coverage[pixel]));
}

} // namespace isomotion::image
