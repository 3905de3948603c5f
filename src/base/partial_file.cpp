#include "base/partial_file.h"

#include <algorithm>
#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include "base/file.h"

namespace isomotion::base {
namespace {

std::filesystem::path neighbour(const std::filesystem::path& destination) {
    std::filesystem::path name = ".";
    name += destination.stem();
    name += ".part";
    name += destination.extension();
    return destination.parent_path() / name;
}

std::filesystem::path folder_of(const std::filesystem::path& path) {
    return path.has_parent_path() ? path.parent_path() : ".";
}

bool still_named(const FileDescriptor& file, const std::filesystem::path& path) {
    struct stat held = {};
    struct stat named = {};
    return ::fstat(file.number(), &held) == 0 && ::lstat(path.c_str(), &named) == 0 &&
           held.st_dev == named.st_dev && held.st_ino == named.st_ino;
}

/// What lies there under the hidden name may be somebody else's: a pipe keeps who opens it waiting,
/// and what has another name is not emptied for a frame.
void refuse_others(const FileDescriptor& file, const std::filesystem::path& path) {
    struct stat found = {};
    if (::fstat(file.number(), &found) != 0) throw FileError(path, "cannot be read", errno);
    if (!S_ISREG(found.st_mode)) throw FileError(path, "is a pipe or a device; remove it");
    if (found.st_nlink > 1) throw FileError(path, "has another name, too; remove it");
}

/// Opens the file and waits for its lock. Whoever had the lock before has usually renamed the file
/// meanwhile; then the name is opened again. A file system without locks is used without.
FileDescriptor open_locked(const std::filesystem::path& path,
                           const std::filesystem::path& destination) {
    constexpr int most_attempts = 1000; // where files change their identity, none would succeed
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
        FileDescriptor file(
            ::open(path.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666));
        if (!file) throw FileError(destination, "cannot be created", errno);
        refuse_others(file, path);
        while (::flock(file.number(), LOCK_EX) != 0 && errno == EINTR) {
        }
        if (still_named(file, path)) return file;
    }
    throw FileError(destination, "cannot be locked", EBUSY);
}

void refuse_special(const std::filesystem::path& destination) {
    struct stat found = {};
    if (::stat(destination.c_str(), &found) != 0 || S_ISREG(found.st_mode)) return;
    if (S_ISDIR(found.st_mode)) throw FileError(destination, "cannot be replaced", EISDIR);
    throw FileError(destination, "cannot be replaced: it is a pipe or a device");
}

/// A renamed file survives a power cut only once its folder is on the disk too. Not every file
/// system and not every permission allows this; what is refused for such a reason is no error.
void sync_folder(const std::filesystem::path& destination) {
    const FileDescriptor folder(
        ::open(folder_of(destination).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!folder) return;
    if (::fsync(folder.number()) != 0 && (errno == EIO || errno == ENOSPC || errno == EDQUOT))
        throw FileError(folder_of(destination), "cannot be brought to the disk", errno);
}

} // namespace

PartialFile::PartialFile(std::filesystem::path destination)
    : destination_(std::move(destination))
    , path_(neighbour(destination_)) {
    refuse_special(destination_);
    file_ = open_locked(path_, destination_);
    if (::ftruncate(file_.number(), 0) != 0) {
        const int code = errno;
        ::unlink(path_.c_str());
        throw FileError(destination_, "cannot be written", code);
    }
}

PartialFile::~PartialFile() {
    if (!published_) ::unlink(path_.c_str()); // before the descriptor, and the lock with it, goes
}

void PartialFile::write(std::span<const std::byte> bytes) {
    write_all(file_.number(), bytes, destination_);
}

void PartialFile::publish(Durability durability) {
    const bool synced = durability == Durability::synced;
    if (synced && ::fsync(file_.number()) != 0)
        throw FileError(destination_, "cannot be brought to the disk", errno);
    // The file stays open, and so locked, until it has its name; after fsync, closing it has no
    // error left to report.
    if (::rename(path_.c_str(), destination_.c_str()) != 0)
        throw FileError(destination_, "cannot be given its name", errno);
    published_ = true;
    file_.close();
    if (synced) sync_folder(destination_);
}

void write_all(int descriptor, std::span<const std::byte> bytes,
               const std::filesystem::path& path) {
    constexpr std::size_t at_once = std::size_t(1) << 30; // one call takes less than 2 GiB
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), std::min(bytes.size(), at_once));
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) throw FileError(path, "cannot be written", errno);
        bytes = bytes.subspan(std::size_t(written));
    }
}

} // namespace isomotion::base
