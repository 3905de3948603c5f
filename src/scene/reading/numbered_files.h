// Finds one file per frame, `sim/p.####.bgeo`.
#pragma once

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "base/confines.h"
#include "scene/reading/document.h"

namespace isomotion::scene {

struct NumberedFile {
    int number = 0;
    std::filesystem::path file;
};

// The files that match `name`, in order of their numbers, which are evenly spaced. None if the name
// has no place for a number, or if a file has exactly this name. Throws SceneError at `key` if
// there is no such file, if one between two others is missing, or if one lies outside its confines.
std::vector<NumberedFile> numbered_files(const toml::node& node, const std::string& key,
                                         const std::filesystem::path& name,
                                         const base::Confines& within);

} // namespace isomotion::scene
