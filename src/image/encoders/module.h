// The functions that image/encoders.h calls, inside the module.
#pragma once

#include <cstddef>
#include <vector>

#include "image/encode.h"
#include "image/frame.h"
#include "image/pixel_hash.h"

namespace isomotion::image::files {

std::vector<std::byte> encode(const Frame& frame, Format format, PixelHash* hash);

} // namespace isomotion::image::files
