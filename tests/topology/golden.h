// The timelines that are kept: golden/NAME.timeline.json is what `isomotion topology NAME -o`
// writes of an animation.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace isomotion::topology {

inline std::filesystem::path golden_file(const std::string& name) {
    return std::filesystem::path(ISOMOTION_SOURCE_DIR) / "tests/topology/golden" /
           (name + ".timeline.json");
}

inline std::vector<std::string> golden_names() {
    constexpr std::string_view extension = ".timeline.json";
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(golden_file("").parent_path())) {
        const std::string file = entry.path().filename().string();
        if (file.ends_with(extension))
            names.push_back(file.substr(0, file.size() - extension.size()));
    }
    std::ranges::sort(names);
    return names;
}

} // namespace isomotion::topology
