#include "image/screen.h"

#include "image/pixel_codes.h"

namespace isomotion::image {

std::vector<std::uint8_t> screen_codes(const Frame& frame) {
    check(frame);
    const ColourPlanes planes = colour_planes(frame);
    const std::size_t area = std::size_t(frame.width) * std::size_t(frame.height);
    std::vector<std::uint8_t> codes;
    codes.reserve(4 * area);
    for (std::size_t pixel = 0; pixel < area; ++pixel) {
        pack_pixel(planes, pixel, codes);
        if (!planes.coverage) codes.push_back(255);
    }
    return codes;
}

} // namespace isomotion::image
