// What a Scene of the public header holds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isomotion/isomotion.h"
#include "scene/scene.h"

namespace isomotion {

struct Scene::Parts {
    scene::Scene scene;
    // What it was loaded from: a name, or a text whose files lie in `folder`.
    std::string source;
    std::optional<std::filesystem::path> folder;
    std::vector<std::string> settings;
    Reach reach = Reach::own_folder;
};

} // namespace isomotion
