#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <isomotion/error.h>

#include "base/confines.h"

namespace isomotion::base {

/// The file system refused an operation, or a file is not what it must be. The message has the
/// path, the attempt or the defect, and the system's reason if there is one.
class FileError : public Error {
public:
    FileError(const std::filesystem::path& path, const std::string& attempt, int code);
    FileError(const std::filesystem::path& path, const std::string& wrong);

    const std::filesystem::path& path() const { return path_; }
    /// The errno, such as ENOSPC; 0 if the system didn't refuse.
    int system_code() const { return code_; }

private:
    std::filesystem::path path_;
    int code_;
};

/// Writes a file that is never visible half-written. The bytes go to `.NAME.part.EXT` in the same
/// folder and reach the disk; only then the file gets its name. An error leaves nothing behind; a
/// killed run leaves at most that one hidden file, which the next run reuses. Two processes that
/// write the same file take turns. A device or a pipe is written directly.
void write_whole(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// The bytes of a regular file (regular_file.h). Refuses a file of more than `most` bytes.
std::vector<std::byte> read_whole(const std::filesystem::path& path,
                                  std::size_t most = std::size_t(4) << 30,
                                  const Confines& within = {});
std::string read_whole_text(const std::filesystem::path& path, std::size_t most,
                            const Confines& within = {});
/// The same for the file of this name in an open folder.
std::string read_whole_text(const FileDescriptor& folder, const std::filesystem::path& path,
                            std::size_t most);

/// The content_hash() of a regular file's bytes, computed in pieces.
std::string hash_of_file(const std::filesystem::path& path);

} // namespace isomotion::base
