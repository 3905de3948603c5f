#pragma once

#include <OpenImageIO/imageio.h>

#include "image/frame.h"

namespace isomotion::image::oiio {

// The entries that a file was written with, except those that describe the file itself.
Metadata entries_of(const OIIO::ImageSpec& spec);

} // namespace isomotion::image::oiio
