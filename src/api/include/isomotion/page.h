// What a browser shows: a scene as a page that plays it, a topology as a plot.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <isomotion/drawing.h>
#include <isomotion/topology.h>

namespace isomotion {

struct PageSettings {
    // A report of `isomotion accuracy`, whose wrong pixels and times the page shows.
    std::optional<std::filesystem::path> report = {};
    std::vector<std::byte> movie = {}; // an MP4, for browsers that cannot draw the scene
};

// A scene as one HTML file, which plays it in a browser.
std::string page_of(const Scene& scene, const PageSettings& settings = {},
                    const std::function<void(const std::string&)>& warn = {});

struct TopologyPlot {
    std::string svg;
    int undrawn = 0;            // pictures, as it was stopped
    std::string why_incomplete; // why other pictures are missing, if any are
};

// Betti numbers over time with a lane for each kind of event. Above them are pictures of the
// surface at the frames that show most, if there is a device.
TopologyPlot plot_of(const Topology& topology, Device* device = nullptr,
                     const Watcher& watcher = {});

} // namespace isomotion
