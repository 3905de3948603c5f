// A scene as one HTML file that plays it: no network, no framework, every shader that `render` has.
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
    // A report of `isomotion accuracy`: the page tells what it measured of the scene's own method.
    std::optional<std::filesystem::path> report;
    // Told what was left out or mended: a timeline of another scene, an environment map.
    std::function<void(const std::string&)> warn = {};
};

// Throws SceneError for what a page cannot show or hold (web_scene.h), InputError for a report that
// is broken or of another scene, and what reading an environment map throws.
std::string page(const scene::Scene& scene, const PageOptions& options = {});

} // namespace isomotion::page
