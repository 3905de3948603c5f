#include "base/file_text.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include <fmt/format.h>

#include "base/input_error.h"

namespace isomotion::base {
namespace fs = std::filesystem;

std::string file_text(const fs::path& file, std::size_t most) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found) {
        throw InputError(fmt::format("{}: no such file", file.string()));
    }
    if (error) {
        throw InputError(fmt::format("{}: cannot be read: {}", file.string(), error.message()));
    }
    if (!fs::is_regular_file(status)) {
        throw InputError(fmt::format("{}: is {}; name a regular file", file.string(),
                                     fs::is_directory(status) ? "a folder" : "a pipe or a device"));
    }
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    // One byte more than there may be tells; a file may also grow while it is read.
    std::string text;
    if (const auto size = fs::file_size(file, error); !error) text.reserve(std::min(size, most));
    constexpr std::size_t piece = 1 << 16;
    while (stream && text.size() <= most) {
        const std::size_t before = text.size();
        text.resize(before + std::min(piece, most + 1 - before));
        stream.read(text.data() + before, std::streamsize(text.size() - before));
        text.resize(before + std::size_t(stream.gcount()));
    }
    if (text.size() > most) {
        throw InputError(
            fmt::format("{}: is larger than {} bytes, the most that is read", file.string(), most));
    }
    if (!stream.eof()) {
        throw InputError(fmt::format("{}: cannot be read: {}", file.string(),
                                     std::strerror(errno ? errno : EIO)));
    }
    return text;
}

} // namespace isomotion::base
