#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "base/confines.h"
#include "base/file_descriptor.h"

namespace isomotion::base {

/// A regular file that is open for reading: the one way in which files of strangers are opened.
/// What is checked is what was opened. A folder, a pipe or a device is refused, as one may never
/// end. Throws FileError, and InputError for what lies outside its confines.
class RegularFile {
public:
    explicit RegularFile(const std::filesystem::path& path, const Confines& within = {});
    /// Under this name in an open folder; messages call it `path`.
    RegularFile(const FileDescriptor& folder, const std::filesystem::path& name,
                const std::filesystem::path& path);

    std::size_t size() const { return size_; } ///< when it was opened
    /// How many bytes there were: as many as there is room for, or fewer at the end.
    std::size_t read(std::span<std::byte> bytes);
    void go_to(std::size_t byte);

private:
    void check();

    std::filesystem::path path_;
    FileDescriptor file_;
    std::size_t size_ = 0;
};

} // namespace isomotion::base
