#pragma once

#include <filesystem>
#include <string>

#include "image/frame.h"

namespace isomotion::image {

/// Reads the first picture of an EXR, HDR, TIFF, PNG or JPEG, told by its first bytes, all
/// channels, with colour as linear light multiplied by coverage. Channels may come in another order
/// than they were written in. No other format is read, and no other file: a stranger's file is safe
/// to read.
///
/// Throws a FileError if the file cannot be read and an ImageError if it is broken or cut short, or
/// would take too much memory: sides of 16,384 and 64 channels are possible.
Frame decode(const std::filesystem::path& file);

/// The PixelHash of a PNG or EXR. Throws what decode() does.
std::string pixel_hash(const std::filesystem::path& file);

} // namespace isomotion::image
