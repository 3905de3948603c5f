#pragma once

#include "image/frame.h"
#include "unit/base/places.h"

namespace isomotion::image {

using base::Disk;
using base::Environment;
using base::TemporaryFolder;

/// An opaque picture of one colour.
inline Frame plain(int width, int height, float red, float green, float blue) {
    const auto area = std::size_t(width) * std::size_t(height);
    Frame frame{width, height, {}, {}};
    frame.channels.push_back({"R", std::vector<float>(area, red)});
    frame.channels.push_back({"G", std::vector<float>(area, green)});
    frame.channels.push_back({"B", std::vector<float>(area, blue)});
    return frame;
}

} // namespace isomotion::image
