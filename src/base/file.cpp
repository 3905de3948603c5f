#include "base/file.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>

#include <fmt/format.h>

#include "base/partial_file.h"
#include "base/printable.h"

namespace isomotion::base {
namespace {

/// A terminal, a pipe, /dev/null: what cannot be replaced by renaming another file to it.
bool is_stream(const std::filesystem::path& path) {
    struct stat found = {};
    return ::stat(path.c_str(), &found) == 0 && !S_ISREG(found.st_mode) && !S_ISDIR(found.st_mode);
}

} // namespace

FileError::FileError(const std::filesystem::path& path, const std::string& attempt, int code)
    : std::runtime_error(fmt::format("{}: {}: {}", printable_line(path.string()), attempt,
                                     std::generic_category().message(code)))
    , path_(path)
    , code_(code) {}

FileError::FileError(const std::filesystem::path& path, const std::string& wrong)
    : std::runtime_error(fmt::format("{}: {}", printable_line(path.string()), wrong))
    , path_(path)
    , code_(0) {}

void write_whole(const std::filesystem::path& path, std::span<const std::byte> bytes) {
    if (is_stream(path)) {
        const FileDescriptor stream(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
        if (!stream) throw FileError(path, "cannot be opened", errno);
        write_all(stream.number(), bytes, path);
        return;
    }
    PartialFile partial(path);
    partial.write(bytes);
    partial.publish();
}

std::vector<std::byte> read_whole(const std::filesystem::path& path, std::size_t most) {
    // A pipe would keep open() waiting for its other end.
    const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (!file) throw FileError(path, "cannot be opened", errno);
    struct stat found = {};
    if (::fstat(file.number(), &found) != 0) throw FileError(path, "cannot be read", errno);
    if (S_ISDIR(found.st_mode)) throw FileError(path, "cannot be read", EISDIR);
    if (!S_ISREG(found.st_mode)) throw FileError(path, "is a pipe or a device");
    const auto too_large = [&] {
        return FileError(path, fmt::format("has more than {} bytes", most), EFBIG);
    };
    if (std::size_t(found.st_size) > most) throw too_large();

    // One byte more than the size, so that the end is met without growing.
    std::vector<std::byte> bytes(std::size_t(found.st_size) + 1);
    std::size_t size = 0;
    for (;;) {
        if (size > most) throw too_large();
        if (size == bytes.size()) bytes.resize(2 * size);
        const ssize_t count = ::read(file.number(), bytes.data() + size, bytes.size() - size);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw FileError(path, "cannot be read", errno);
        if (count == 0) break;
        size += std::size_t(count);
    }
    bytes.resize(size);
    return bytes;
}

} // namespace isomotion::base
