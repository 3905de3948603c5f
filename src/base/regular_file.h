#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "base/confines.h"
#include "base/file_descriptor.h"

namespace isomotion::base {

/// A regular file that is open for reading. All files of strangers are opened by this class. The
/// check is made on the opened file. It refuses a folder, a pipe or a device, since reading these
/// may never end. Throws FileError, and InputError for a file outside its confines.
class RegularFile {
public:
    explicit RegularFile(const std::filesystem::path& path, const Confines& within = {});
    /// The file of this name in an open folder; messages call it `path`.
    RegularFile(const FileDescriptor& folder, const std::filesystem::path& name,
                const std::filesystem::path& path);

    std::size_t size() const { return size_; } ///< when it was opened
    /// Reads as many bytes as fit, fewer at the end; returns their number.
    std::size_t read(std::span<std::byte> bytes);
    void go_to(std::size_t byte);

private:
    void check();

    std::filesystem::path path_;
    FileDescriptor file_;
    std::size_t size_ = 0;
};

} // namespace isomotion::base
