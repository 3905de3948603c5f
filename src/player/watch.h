// Which files have changed since they were last read.
//
// By asking for each file's inode, size and time whenever told to: a dozen system calls, which work
// on every file system, and see editors that write in place and those that rename another file
// over it. A change is told once, when the file has looked the same twice in a row: not while
// it is being written. A file that is missing for a moment is waited for. What is written twice
// within one tick of the file system's clock (some ms) with the same size is not told apart.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "scene/scene.h"

namespace isomotion::player {

class FileWatch {
public:
    explicit FileWatch(const std::vector<std::filesystem::path>& files = {});

    // Watches these from now on; those watched before stay as they are, with what is not yet told.
    void watch(const std::vector<std::filesystem::path>& files);

    // Files that have changed since they were told or first watched, in their order by name.
    std::vector<std::filesystem::path> changed();

private:
    struct Stamp {
        std::uint64_t device = 0, inode = 0;
        std::int64_t size = 0, seconds = 0, nanoseconds = 0;

        bool operator==(const Stamp&) const = default;
    };
    struct Watched {
        std::optional<Stamp> told; // as it was read; none if there was no file
        std::optional<Stamp> seen; // at the last look
    };
    static std::optional<Stamp> stamp(const std::filesystem::path& file);

    std::map<std::filesystem::path, Watched> files_;
};

// What a scene was made of: its file, the catalogue's, tables of elements and the environment map.
std::vector<std::filesystem::path> files_of(const scene::Scene& scene);
// What a scene file names, as far as it can be read: the file itself at least. They need not exist.
std::vector<std::filesystem::path> files_named(const std::filesystem::path& scene);
// The program's shaders.
std::vector<std::filesystem::path> shader_files();

} // namespace isomotion::player
