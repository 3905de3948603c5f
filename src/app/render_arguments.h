// What is asked of `render`, and how its words become settings.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/load.h"
#include "synthesis/channel.h"

namespace isomotion::app {

struct RenderArguments {
    std::string scene, output, frames, size, method, backend = "auto", channels, movie;
    std::string stage = "fragment";
    std::string step;
    std::vector<std::string> settings;
    std::optional<double> max_wrong; // ppm
    int bits = 8;
    bool resume = false, quiet = false, certify = false;
};

// Each of these throws std::invalid_argument with a message that names the option as it was
// written, not the key of the scene file that it stands for.

// The scene's keys that the options set, --set first.
std::vector<scene::Override> overrides(const RenderArguments& arguments);

// In one order, whatever the user's: it decides shader text and fingerprint.
std::vector<synthesis::Channel> parse_channels(const std::string& text);

} // namespace isomotion::app
