#include "base/confines.h"

#include <algorithm>

#include <fcntl.h>

#include <fmt/format.h>

namespace isomotion::base {
namespace fs = std::filesystem;

std::optional<fs::path> place_of(const FileDescriptor& open) {
    std::error_code error;
    fs::path place = fs::read_symlink(fmt::format("/proc/self/fd/{}", open.number()), error);
    if (error || !place.is_absolute()) return std::nullopt;
    return place;
}

FileDescriptor open_folder(const fs::path& folder) {
    const char* name = folder.empty() ? "." : folder.c_str();
    return FileDescriptor(::open(name, O_PATH | O_DIRECTORY | O_CLOEXEC));
}

bool Confines::hold(const FileDescriptor& open) const {
    if (!folders_) return true;
    const std::optional<fs::path> place = place_of(open);
    return place && std::ranges::any_of(*folders_, [&](const fs::path& folder) {
               return std::mismatch(folder.begin(), folder.end(), place->begin(), place->end())
                          .first == folder.end();
           });
}

} // namespace isomotion::base
