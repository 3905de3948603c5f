#pragma once

#include <filesystem>
#include <string>

#include "image/frame.h"

namespace isomotion::image {

/// Reads the first picture of an EXR, HDR, TIFF, PNG or JPEG, identified by its first bytes, with
/// all channels and premultiplied linear colour. Channels may come in another order than they were
/// written in. No other format and no other file is read, so a stranger's file is safe to read.
///
/// Throws a FileError if the file cannot be read, and an ImageError if it is broken or cut short,
/// or would take too much memory: at most sides of 16,384 and 64 channels.
Frame decode(const std::filesystem::path& file);

/// The PixelHash of a PNG or EXR. Throws the same as decode().
std::string pixel_hash(const std::filesystem::path& file);

} // namespace isomotion::image
