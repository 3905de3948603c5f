#include "base/regular_file.h"

#include <cerrno>

#include <fcntl.h>
#include <sys/stat.h>

#include <fmt/format.h>

#include "base/file.h"
#include "base/input_error.h"
#include "base/printable.h"

namespace isomotion::base {
namespace {

// A pipe would keep open() waiting for its other end.
constexpr int careful = O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY;

} // namespace

RegularFile::RegularFile(const std::filesystem::path& path, const Confines& within)
    : path_(path)
    , file_(::open(path.c_str(), careful)) {
    check();
    if (!within.hold(file_)) {
        throw InputError(fmt::format("{} {}", printable_line(path.string()), within.refusal()));
    }
}

RegularFile::RegularFile(const FileDescriptor& folder, const std::filesystem::path& name,
                         const std::filesystem::path& path)
    : path_(path)
    , file_(::openat(folder.number(), name.c_str(), careful)) {
    check();
}

void RegularFile::check() {
    if (!file_) throw FileError(path_, "cannot be opened", errno);
    struct stat found = {};
    if (::fstat(file_.number(), &found) != 0) throw FileError(path_, "cannot be read", errno);
    if (S_ISDIR(found.st_mode)) throw FileError(path_, "cannot be read", EISDIR);
    if (!S_ISREG(found.st_mode)) throw FileError(path_, "is a pipe or a device");
    size_ = std::size_t(found.st_size);
}

std::size_t RegularFile::read(std::span<std::byte> bytes) {
    std::size_t size = 0;
    while (size < bytes.size()) {
        const ssize_t count = ::read(file_.number(), bytes.data() + size, bytes.size() - size);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw FileError(path_, "cannot be read", errno);
        if (count == 0) break;
        size += std::size_t(count);
    }
    return size;
}

void RegularFile::go_to(std::size_t byte) {
    if (::lseek(file_.number(), off_t(byte), SEEK_SET) < 0)
        throw FileError(path_, "cannot be read", errno);
}

} // namespace isomotion::base
