#include "base/file_stamp.h"

#include <sys/stat.h>

namespace isomotion::base {

std::optional<FileStamp> stamp_of(const std::filesystem::path& file) {
    struct stat found = {};
    if (::stat(file.c_str(), &found) != 0 || !S_ISREG(found.st_mode)) return std::nullopt;
    return FileStamp{std::uint64_t(found.st_dev), std::uint64_t(found.st_ino),
                     std::int64_t(found.st_size), std::int64_t(found.st_mtim.tv_sec),
                     std::int64_t(found.st_mtim.tv_nsec)};
}

} // namespace isomotion::base
