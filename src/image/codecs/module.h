// What image/codecs.h calls, inside the module.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "image/encode.h"
#include "image/environment.h"
#include "image/frame.h"
#include "image/pixel_hash.h"

namespace isomotion::image::oiio {

std::vector<std::byte> encode(const Frame& frame, Format format, PixelHash* hash);
Frame decode(const std::filesystem::path& file);
std::string pixel_hash(const std::filesystem::path& file);
int read_environment(const std::filesystem::path& file, const EnvironmentSink& sink,
                     const base::Confines& within);

} // namespace isomotion::image::oiio
