#include "scene/files_read.h"

#include <algorithm>

#include "scene/data_folder.h"

namespace isomotion::scene {

std::vector<std::filesystem::path> files_read(const Scene& scene) {
    std::vector<std::filesystem::path> files;
    if (scene.formula.empty()) files.push_back(scene.file);
    for (const Surface& surface : scene.surfaces) {
        if (!surface.name.empty()) files.push_back(surface_file(surface.name));
        if (!surface.look.name.empty()) files.push_back(look_file(surface.look.name));
    }
    if (scene.environment) files.push_back(scene.environment->map);
    for (const Surface& surface : scene.surfaces) {
        for (const animation::Array& array : surface.animation.arrays()) {
            if (!array.samples) continue;
            for (auto& file : array.samples->source().files()) files.push_back(std::move(file));
        }
    }
    std::vector<std::filesystem::path> once; // surfaces may share them
    for (auto& file : files) {
        if (std::ranges::find(once, file) == once.end()) once.push_back(std::move(file));
    }
    return once;
}

} // namespace isomotion::scene
