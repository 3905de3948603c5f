#include "scene/files_read.h"

#include <algorithm>

#include "scene/data_folder.h"

namespace isomotion::scene {

std::vector<std::filesystem::path> files_read(const Scene& scene) {
    std::vector<std::filesystem::path> files;
    if (scene.formula.empty()) files.push_back(scene.file);
    if (!scene.surface.name.empty()) files.push_back(surface_file(scene.surface.name));
    if (!scene.look.name.empty()) files.push_back(look_file(scene.look.name));
    if (scene.environment) files.push_back(scene.environment->map);
    for (const animation::Array& array : scene.surface.animation.arrays()) {
        if (!array.samples) continue;
        for (auto& file : array.samples->source().files()) files.push_back(std::move(file));
    }
    for (const Scene& other : scene.others) {
        for (auto& file : files_read(other)) files.push_back(std::move(file));
    }
    std::vector<std::filesystem::path> once; // surfaces may share them
    for (auto& file : files) {
        if (std::ranges::find(once, file) == once.end()) once.push_back(std::move(file));
    }
    return once;
}

} // namespace isomotion::scene
