#pragma once

#include <cstdint>
#include <vector>

#include "image/frame.h"

namespace isomotion::image {

/// The colours as sRGB in 8 bits, not premultiplied: R, G, B and A of each pixel, row by row from
/// the top. A pixel without coverage is 0. Throws an ImageError if R, G or B is missing.
std::vector<std::uint8_t> rgba8(const Frame& frame);

} // namespace isomotion::image
