#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/confines.h"

namespace isomotion::base {

/// The file system refused, or a file is not what it has to be. The message has the path, what was
/// tried or is wrong, and the system's reason if there is one.
class FileError : public std::runtime_error {
public:
    FileError(const std::filesystem::path& path, const std::string& attempt, int code);
    FileError(const std::filesystem::path& path, const std::string& wrong);

    const std::filesystem::path& path() const { return path_; }
    /// The errno, such as ENOSPC; 0 where it was not the system that refused.
    int code() const { return code_; }

private:
    std::filesystem::path path_;
    int code_;
};

/// Writes a file that is never seen half done: the bytes go to `.NAME.part.EXT` in the same folder,
/// reach the disk and only then take the name. Nothing is left behind on an error; a killed run
/// leaves at most that one hidden file, which the next run uses again. Two processes that write the
/// same file take turns. A device or a pipe is written straight.
void write_whole(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// A regular file's bytes (regular_file.h). A file of more than `most` bytes is refused.
std::vector<std::byte> read_whole(const std::filesystem::path& path,
                                  std::size_t most = std::size_t(4) << 30,
                                  const Confines& within = {});
std::string read_whole_text(const std::filesystem::path& path, std::size_t most,
                            const Confines& within = {});
/// Of the file of this name in an open folder.
std::string read_whole_text(const FileDescriptor& folder, const std::filesystem::path& path,
                            std::size_t most);

/// The content_hash() of a regular file's bytes, of which few are held at once.
std::string hash_of_file(const std::filesystem::path& path);

} // namespace isomotion::base
