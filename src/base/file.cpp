#include "base/file.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>

#include <fmt/format.h>

#include "base/content_hash.h"
#include "base/partial_file.h"
#include "base/printable.h"
#include "base/regular_file.h"

namespace isomotion::base {
namespace {

/// A terminal, a pipe, /dev/null: what cannot be replaced by renaming another file to it.
bool is_stream(const std::filesystem::path& path) {
    struct stat found = {};
    return ::stat(path.c_str(), &found) == 0 && !S_ISREG(found.st_mode) && !S_ISDIR(found.st_mode);
}

template<class Bytes>
Bytes read_as(RegularFile file, const std::filesystem::path& path, std::size_t most) {
    const auto too_large = [&] {
        return FileError(path, fmt::format("has more than {} bytes", most), EFBIG);
    };
    if (file.size() > most) throw too_large();

    // One byte more than the size, so that the end is met without growing.
    Bytes bytes;
    bytes.resize(file.size() + 1);
    std::size_t size = 0;
    for (;;) {
        size += file.read(std::as_writable_bytes(std::span(bytes)).subspan(size));
        if (size > most) throw too_large();
        if (size < bytes.size()) break;
        bytes.resize(2 * size);
    }
    bytes.resize(size);
    return bytes;
}

} // namespace

FileError::FileError(const std::filesystem::path& path, const std::string& attempt, int code)
    : Error(Code::file, fmt::format("{}: {}: {}", printable_line(path.string()), attempt,
                                    std::generic_category().message(code)))
    , path_(path)
    , code_(code) {}

FileError::FileError(const std::filesystem::path& path, const std::string& wrong)
    : Error(Code::file, fmt::format("{}: {}", printable_line(path.string()), wrong))
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

std::vector<std::byte> read_whole(const std::filesystem::path& path, std::size_t most,
                                  const Confines& within) {
    return read_as<std::vector<std::byte>>(RegularFile(path, within), path, most);
}

std::string read_whole_text(const std::filesystem::path& path, std::size_t most,
                            const Confines& within) {
    return read_as<std::string>(RegularFile(path, within), path, most);
}

std::string read_whole_text(const FileDescriptor& folder, const std::filesystem::path& path,
                            std::size_t most) {
    return read_as<std::string>(RegularFile(folder, path.filename(), path), path, most);
}

std::string hash_of_file(const std::filesystem::path& path) {
    RegularFile file(path);
    ContentHash hash;
    std::vector<std::byte> piece(std::size_t(1) << 20);
    while (const std::size_t count = file.read(piece))
        hash.add(std::span<const std::byte>(piece).first(count));
    return hash.text();
}

} // namespace isomotion::base
