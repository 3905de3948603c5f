#include "image/environment.h"

#include <fmt/format.h>

namespace isomotion::image {

std::string mending(const std::filesystem::path& file, int mended) {
    return fmt::format("environment {}: {} not finite or below 0: NaN and what is below 0 became "
                       "0, infinity the map's largest finite value",
                       file.string(),
                       mended == 1 ? "1 texel was" : fmt::format("{} texels were", mended));
}

} // namespace isomotion::image
