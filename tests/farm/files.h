// The files of a folder that are frames, movies or scripts, not what is kept beside them in
// folders.
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace isomotion::farm {

inline std::set<std::string> files_in(const std::filesystem::path& folder) {
    std::set<std::string> names;
    std::error_code missing;
    for (const auto& entry : std::filesystem::directory_iterator(folder, missing)) {
        if (entry.is_regular_file()) names.insert(entry.path().filename());
    }
    return names;
}

} // namespace isomotion::farm
