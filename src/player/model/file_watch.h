// Detects files that have changed since they were last read.
//
// Each call compares every file's inode, size and time. These are a dozen system calls that work on
// every file system, both for editors that write in place and for those that rename another file
// over it. A change is reported once, when the file has looked the same twice in a row, so never
// while it is being written. A file that is missing for a moment is waited for. Two writes of the
// same size within one tick of the file system's clock (some ms) count as one.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "base/file_stamp.h"
#include "scene/scene.h"

namespace isomotion::player {

class FileWatch {
public:
    explicit FileWatch(const std::vector<std::filesystem::path>& files = {});

    // Watches these files from now on. Unreported changes of files watched before are kept.
    void watch(const std::vector<std::filesystem::path>& files);

    // Files that have changed since they were last reported or first watched, ordered by name.
    std::vector<std::filesystem::path> changed();

private:
    struct Watched {
        std::optional<base::FileStamp> told; // when last reported; none if there was no file
        std::optional<base::FileStamp> seen; // at the last call
    };

    std::map<std::filesystem::path, Watched> files_;
};

// The files of which a scene was made: its own, the catalogue's, tables, the environment map.
std::vector<std::filesystem::path> files_of(const scene::Scene& scene);
// The scene file itself and the files that it names, as far as it can be read. They need not exist.
std::vector<std::filesystem::path> files_named(const std::filesystem::path& scene);
// The program's shaders.
std::vector<std::filesystem::path> shader_files();

} // namespace isomotion::player
