// Decodes samples of a picture to colour: linear light, premultiplied.
#pragma once

#include <functional>

#include "image/frame.h"
#include "picture_file.h"

namespace isomotion::image::oiio {

// Calls take(begin, rows) for all rows from the top; `rows` are the channels of some rows, starting
// with row `begin`, and take may keep them. Only these rows are in memory.
void for_each_decoded_band(PictureFile& picture, const std::function<void(int, Frame&&)>& take);

} // namespace isomotion::image::oiio
