#pragma once

#include <filesystem>
#include <string>

#include "image/frame.h"

namespace isomotion::image {

/// Reads the first picture of a file that OpenImageIO knows, all channels, with colour as linear
/// light multiplied by coverage. Channels may come in another order than they were written in.
///
/// Throws a FileError if the file cannot be read and an ImageError if it is broken or cut short.
Frame decode(const std::filesystem::path& file);

/// The PixelHash of a PNG or EXR. Throws what decode() does.
std::string pixel_hash(const std::filesystem::path& file);

} // namespace isomotion::image
