#pragma once

#include "image/frame.h"
#include "picture_file.h"

namespace isomotion::image::oiio {

// The picture's channels as image::decode() gives them.
Frame decode(PictureFile& picture);

} // namespace isomotion::image::oiio
