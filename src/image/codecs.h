// The functions of the module isomotion_codecs.so, which reads files by OpenImageIO. It is loaded
// at the first call, since OpenImageIO's 260 shared libraries take a quarter of a second to load.
#pragma once

#include <filesystem>
#include <string>

#include "image/environment.h"
#include "image/frame.h"

namespace isomotion::image {

struct Codecs {
    Frame (*decode)(const std::filesystem::path& file);
    std::string (*pixel_hash)(const std::filesystem::path& file);
    int (*read_environment)(const std::filesystem::path& file, const EnvironmentSink& sink,
                            const base::Confines& within);
};

// Throws std::runtime_error if the module cannot be loaded. May be called from any thread.
const Codecs& codecs();

} // namespace isomotion::image
