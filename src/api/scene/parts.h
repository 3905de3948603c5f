// What a Scene of the public header holds.
#pragma once

#include <functional>
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
    // What was made of it once it was loaded, in order.
    std::vector<std::function<scene::Scene(const scene::Scene&)>> changes = {};
};

namespace api {

// The scene loaded again with so many frames.
Scene with_frames(const Scene& scene, int frames);

// The scene with one more change.
Scene changed(const Scene& scene, std::function<scene::Scene(const scene::Scene&)> change);

// The frame's number; throws an Error if there is no such frame.
inline int checked_frame(int frame) {
    if (frame >= 1) return frame;
    throw Error(Error::Code::input, "frame " + std::to_string(frame) + ": frames count from 1");
}

} // namespace api

} // namespace isomotion
