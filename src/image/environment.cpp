#include "image/environment.h"

#include <fmt/format.h>

#include "base/printable.h"

namespace isomotion::image {

std::string mending(const std::filesystem::path& file, int mended) {
    return fmt::format("environment {}: {} not finite, below 0 or above 10^6: NaN and what is "
                       "below 0 became 0, infinity the map's largest finite value, and nothing is "
                       "brighter than 10^6",
                       base::printable_line(file.string()),
                       mended == 1 ? "1 texel was" : fmt::format("{} texels were", mended));
}

} // namespace isomotion::image
