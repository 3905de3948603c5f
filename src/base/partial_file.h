#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "base/file_descriptor.h"

namespace isomotion::base {

/// What a power cut may cost.
enum class Durability {
    synced,  ///< nothing: the bytes are on the disk when the file takes its name
    at_ease, ///< the file, then empty or as it was; saves the milliseconds that a disk takes
};

/// The hidden neighbour in which a file is made before it takes its name. It is removed unless it
/// is published. Its name follows from the destination's and keeps the extension, from which
/// programs guess the format; a lock makes two writers of one destination take turns, since they
/// share that name.
class PartialFile {
public:
    explicit PartialFile(std::filesystem::path destination);
    ~PartialFile();
    PartialFile(const PartialFile&) = delete;
    PartialFile& operator=(const PartialFile&) = delete;

    const std::filesystem::path& path() const { return path_; }

    void write(std::span<const std::byte> bytes);

    /// Brings the bytes to the disk, if synced, and gives the file its name.
    void publish(Durability durability = Durability::synced);

private:
    std::filesystem::path destination_;
    std::filesystem::path path_;
    FileDescriptor file_;
    bool published_ = false;
};

/// Writes all bytes to a descriptor; a FileError names the path.
void write_all(int descriptor, std::span<const std::byte> bytes, const std::filesystem::path& path);

} // namespace isomotion::base
