#include <cmath>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <unistd.h>

#include "base/file.h"
#include "fuzz/targets.h"
#include "image/codecs.h"
#include "image/decode.h"
#include "image/environment.h"

namespace isomotion::fuzz {
namespace {

// A file of this process, gone with it.
class File {
public:
    File()
        : path_(std::filesystem::temp_directory_path() / fmt::format("picture.{}", ::getpid())) {}
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File() { std::filesystem::remove(path_); }

    const std::filesystem::path& holding(std::string_view bytes) const {
        std::ofstream(path_, std::ios::binary | std::ios::trunc)
            .write(bytes.data(), std::streamsize(bytes.size()));
        return path_;
    }

private:
    std::filesystem::path path_;
};

} // namespace

void picture(std::string_view bytes) {
    static const File file;
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
