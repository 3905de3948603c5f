#pragma once

#include <cstdint>
#include <vector>

#include "image/frame.h"

namespace isomotion::image {

/// The frame's picture for a screen: R, G, B as sRGB and A, four codes a pixel, the top row first.
/// They are those that a PNG of 8 bits holds; of a frame without coverage A is 255.
std::vector<std::uint8_t> screen_codes(const Frame& frame);

} // namespace isomotion::image
