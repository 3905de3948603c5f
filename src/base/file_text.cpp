#include "base/file_text.h"

#include <cerrno>
#include <system_error>

#include <fmt/format.h>

#include "base/file.h"
#include "base/input_error.h"
#include "base/printable.h"

namespace isomotion::base {
namespace {

// What is wrong with it, and what would be right.
std::string mistake(const FileError& error, std::size_t most) {
    switch (error.system_code()) {
    case 0:
    case ENXIO: // a socket
        return "is a pipe or a device; name a regular file";
    case ENOENT:
    case ENOTDIR:
        return "no such file";
    case EISDIR:
        return "is a folder; name a regular file";
    case EFBIG:
        return fmt::format("is larger than {} bytes, the most that is read", most);
    default:
        return "cannot be read: " + std::generic_category().message(error.system_code());
    }
}

template<class Read>
std::string text_or_mistake(const std::filesystem::path& file, std::size_t most, Read&& read) {
    try {
        return read();
    } catch (const FileError& error) {
        throw InputError(
            fmt::format("{}: {}", printable_line(file.string()), mistake(error, most)));
    }
}

} // namespace

std::string file_text(const std::filesystem::path& file, std::size_t most, const Confines& within) {
    return text_or_mistake(file, most, [&] { return read_whole_text(file, most, within); });
}

std::string file_text(const FileDescriptor& folder, const std::filesystem::path& file,
                      std::size_t most) {
    return text_or_mistake(file, most, [&] { return read_whole_text(folder, file, most); });
}

} // namespace isomotion::base
