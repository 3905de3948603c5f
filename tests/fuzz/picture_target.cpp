#include <cmath>

#include "base/file.h"
#include "fuzz/scratch_file.h"
#include "fuzz/targets.h"
#include "image/decode.h"
#include "image/environment.h"

namespace isomotion::fuzz {
void picture(std::string_view bytes) {
    static const ScratchFile file("picture");
    const std::filesystem::path& path = file.holding(bytes);
    try {
        const image::EnvironmentMap map = image::read_environment(path);
        if (map.width != 2 * map.height ||
            map.texels.size() != 4 * std::size_t(map.width) * std::size_t(map.height)) {
            throw Violation("a map of another size than it says");
        }
        for (const float texel : map.texels) {
            if (!std::isfinite(texel) || texel < 0) throw Violation("a texel that is not light");
        }
    } catch (const image::ImageError&) {
    } catch (const base::FileError&) {
    }
    try {
        image::pixel_hash(path); // as `verify --pixels` reads what may be any picture
    } catch (const image::ImageError&) {
    } catch (const base::FileError&) {
    }
}

} // namespace isomotion::fuzz
