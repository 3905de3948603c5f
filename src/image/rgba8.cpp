#include "image/rgba8.h"

#include <algorithm>

#include "image/srgb.h"

namespace isomotion::image {

std::vector<std::uint8_t> rgba8(const Frame& frame) {
    const ColourPlanes planes = colour_planes(frame);
    const Srgb8& srgb = srgb8();
    const std::size_t count = std::size_t(frame.width) * std::size_t(frame.height);
    std::vector<std::uint8_t> rgba(4 * count);
    std::uint8_t* out = rgba.data();
    for (std::size_t i = 0; i < count; ++i, out += 4) {
        const float coverage = planes.coverage ? std::min(planes.coverage[i], 1.0f) : 1.0f;
        out[3] = quantised<std::uint8_t>(coverage);
        if (!(coverage > 0.0f)) continue; // no colour, which is 0
        const float scale = 1.0f / coverage;
        out[0] = srgb.code(planes.red[i] * scale);
        out[1] = srgb.code(planes.green[i] * scale);
        out[2] = srgb.code(planes.blue[i] * scale);
    }
    return rgba;
}

} // namespace isomotion::image
