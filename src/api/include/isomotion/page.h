// A scene as a page that plays it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <isomotion/scene.h>

namespace isomotion {

struct PageSettings {
    // A report of `isomotion accuracy`, whose wrong pixels and times the page shows.
    std::optional<std::filesystem::path> report = {};
    std::vector<std::byte> movie = {}; // an MP4, for browsers that cannot draw the scene
};

// A scene as one HTML file, which plays it in a browser.
std::string page_of(const Scene& scene, const PageSettings& settings = {},
                    const std::function<void(const std::string&)>& warn = {});

} // namespace isomotion
