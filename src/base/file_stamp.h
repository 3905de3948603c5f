// Tells whether a file is still what it was, without reading it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace isomotion::base {

struct FileStamp {
    std::uint64_t device = 0, file = 0;
    std::int64_t bytes = 0, seconds = 0, nanoseconds = 0; // of its last change

    bool operator==(const FileStamp&) const = default;
};

// None for what is no regular file.
std::optional<FileStamp> stamp_of(const std::filesystem::path& file);

} // namespace isomotion::base
