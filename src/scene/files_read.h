// The files that a scene was read from.
#pragma once

#include <filesystem>
#include <vector>

#include "scene/scene.h"

namespace isomotion::scene {

// Its own, those of the program that it names (a surface of the catalogue, a look), the tables of
// its elements, and its environment's map; of all its surfaces.
std::vector<std::filesystem::path> files_read(const Scene& scene);

} // namespace isomotion::scene
