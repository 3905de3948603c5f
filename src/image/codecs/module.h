// The functions that image/codecs.h calls, inside the module.
#pragma once

#include <filesystem>
#include <string>

#include "image/environment.h"
#include "image/frame.h"

namespace isomotion::image::oiio {

Frame decode(const std::filesystem::path& file);
std::string pixel_hash(const std::filesystem::path& file);
int read_environment(const std::filesystem::path& file, const EnvironmentSink& sink,
                     const base::Confines& within);

} // namespace isomotion::image::oiio
