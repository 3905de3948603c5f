// The functions of the module isomotion_encoders.so, which writes files by libpng and OpenEXR. It
// is loaded at the first call.
#pragma once

#include <cstddef>
#include <vector>

#include "image/encode.h"
#include "image/frame.h"
#include "image/pixel_hash.h"

namespace isomotion::image {

struct Encoders {
    std::vector<std::byte> (*encode)(const Frame& frame, Format format, PixelHash* hash);
};

// Throws std::runtime_error if the module cannot be loaded. May be called from any thread.
const Encoders& encoders();

} // namespace isomotion::image
