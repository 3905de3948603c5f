#include "base/file.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>

#include <fmt/format.h>

#include "base/content_hash.h"
#include "base/partial_file.h"
#include "base/printable.h"

namespace isomotion::base {
namespace {

/// A terminal, a pipe, /dev/null: what cannot be replaced by renaming another file to it.
bool is_stream(const std::filesystem::path& path) {
    struct stat found = {};
    return ::stat(path.c_str(), &found) == 0 && !S_ISREG(found.st_mode) && !S_ISDIR(found.st_mode);
}

struct OpenFile {
    FileDescriptor descriptor;
    std::size_t size = 0;
};

OpenFile open_regular(const std::filesystem::path& path) {
    // A pipe would keep open() waiting for its other end.
    FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (!file) throw FileError(path, "cannot be opened", errno);
    struct stat found = {};
    if (::fstat(file.number(), &found) != 0) throw FileError(path, "cannot be read", errno);
    if (S_ISDIR(found.st_mode)) throw FileError(path, "cannot be read", EISDIR);
    if (!S_ISREG(found.st_mode)) throw FileError(path, "is a pipe or a device");
    return {std::move(file), std::size_t(found.st_size)};
}

// How many bytes there were, 0 at the end.
std::size_t read_some(const OpenFile& file, std::span<std::byte> bytes,
                      const std::filesystem::path& path) {
    for (;;) {
        const ssize_t count = ::read(file.descriptor.number(), bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw FileError(path, "cannot be read", errno);
        return std::size_t(count);
    }
}

template<class Bytes> Bytes read_as(const std::filesystem::path& path, std::size_t most) {
    const OpenFile file = open_regular(path);
    const auto too_large = [&] {
        return FileError(path, fmt::format("has more than {} bytes", most), EFBIG);
    };
    if (file.size > most) throw too_large();

    // One byte more than the size, so that the end is met without growing.
    Bytes bytes;
    bytes.resize(file.size + 1);
    std::size_t size = 0;
    for (;;) {
        if (size > most) throw too_large();
        if (size == bytes.size()) bytes.resize(2 * size);
        const auto rest = std::as_writable_bytes(std::span(bytes)).subspan(size);
        const std::size_t count = read_some(file, rest, path);
        if (count == 0) break;
        size += count;
    }
    bytes.resize(size);
    return bytes;
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
    return read_as<std::vector<std::byte>>(path, most);
}

std::string hash_of_file(const std::filesystem::path& path) {
    const OpenFile file = open_regular(path);
    ContentHash hash;
    std::vector<std::byte> piece(std::size_t(1) << 20);
    while (const std::size_t count = read_some(file, piece, path)) {
        hash.add(std::span<const std::byte>(piece).first(count));
    }
    return hash.text();
}

std::string read_whole_text(const std::filesystem::path& path, std::size_t most) {
    return read_as<std::string>(path, most);
}

} // namespace isomotion::base
