// Samples of a picture as colour: linear light, multiplied by coverage.
#pragma once

#include <functional>

#include "image/frame.h"
#include "picture_file.h"

namespace isomotion::image::oiio {

// Calls take(begin, rows) for all rows from the top; `rows` are some rows' channels, beginning with
// row `begin`, which take may keep. No more of the picture is held at once.
void for_each_decoded_band(PictureFile& picture, const std::function<void(int, Frame&&)>& take);

} // namespace isomotion::image::oiio
