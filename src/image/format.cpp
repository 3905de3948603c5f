#include <fmt/format.h>

#include "base/extension.h"
#include "image/encode.h"

namespace isomotion::image {

Format format_of(const std::filesystem::path& file, PngDepth depth) {
    const std::string extension = base::lower_extension(file);
    if (extension == ".png") return depth == PngDepth::bits16 ? Format::png16 : Format::png8;
    if (extension == ".exr") return Format::exr;
    throw ImageError(fmt::format("{}: {}; a picture's name ends in .png or .exr", file.string(),
                                 extension.empty() ? "no extension says the format"
                                                   : "unknown extension " + extension));
}

} // namespace isomotion::image
