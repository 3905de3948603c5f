#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "base/file_descriptor.h"

namespace isomotion::base {

/// The loss that a power cut may cause.
enum class Durability {
    synced,  ///< none: the bytes are on the disk when the file gets its name
    at_ease, ///< the file may be empty or unchanged; saves the milliseconds that a disk takes
};

/// The hidden neighbour in which a file is written before it gets its name. It is removed unless it
/// is published. Its name is derived from the destination's and keeps the extension, by which
/// programs guess the format. Two writers of one destination share that name, so a lock makes them
/// take turns.
class PartialFile {
public:
    explicit PartialFile(std::filesystem::path destination);
    ~PartialFile();
    PartialFile(const PartialFile&) = delete;
    PartialFile& operator=(const PartialFile&) = delete;

    const std::filesystem::path& path() const { return path_; }

    void write(std::span<const std::byte> bytes);

    /// Flushes the bytes to the disk, if synced, and gives the file its name.
    void publish(Durability durability = Durability::synced);

private:
    std::filesystem::path destination_;
    std::filesystem::path path_;
    FileDescriptor file_;
    bool published_ = false;
};

/// Writes all bytes to a descriptor; a FileError names `path`.
void write_all(int descriptor, std::span<const std::byte> bytes, const std::filesystem::path& path);

} // namespace isomotion::base
