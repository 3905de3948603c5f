// The scenes whose rays are checked: every surface as it comes, and two animations that sum over an
// array or have real powers.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "catalogue/surface_file.h"
#include "scene/reading/load.h"

namespace isomotion::roots_arb {

inline std::filesystem::path animations() {
    return std::filesystem::path(ISOMOTION_SOURCE_DIR) / "animations";
}

inline std::vector<std::string> every_surface() {
    std::vector<std::string> names;
    for (const auto& file : std::filesystem::directory_iterator(animations() / "surfaces")) {
        if (file.path().extension() == ".toml") names.push_back(file.path().stem().string());
    }
    std::ranges::sort(names);
    return names;
}

inline std::vector<std::string> every_scene() {
    std::vector<std::string> names = every_surface();
    names.insert(names.end(), {"blobby75", "twisting_superquadric"});
    return names;
}

// The surface of that name, or else the animation, in its first frame.
inline catalogue::Used scene_named(const std::string& name) {
    if (std::filesystem::exists(animations() / "surfaces" / (name + ".toml"))) {
        return catalogue::used(name);
    }
    catalogue::use_source_tree();
    catalogue::Used result{scene::load((animations() / (name + ".toml")).string()), {}};
    result.at = scene::at_frame(result.scene, 1);
    return result;
}

} // namespace isomotion::roots_arb
