// A scene as one HTML file that plays it, without network or framework, with every shader that
// `render` uses.
//
// The file holds the passes' text in GLSL ES 3.00, the values of every frame as render uploads
// them, and the scripts of web/, which draw with WebGL2.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace isomotion::page {

struct PageOptions {
    std::vector<std::byte> movie; // an MP4, shown where a browser cannot draw the scene
    // A report of `isomotion accuracy`; the page shows its measurements of the scene's own method.
    std::optional<std::filesystem::path> report;
    // Called for data that was left out or repaired: a timeline of another scene, an environment
    // map.
    std::function<void(const std::string&)> warn = {};
};

// Throws SceneError for a scene that a page cannot show or hold (web_scene.h), InputError for a
// report that is broken or of another scene, and the errors of reading an environment map.
std::string page(const scene::Scene& scene, const PageOptions& options = {});

} // namespace isomotion::page
