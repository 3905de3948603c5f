// The live window: isomotion play.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/reading/load.h"

namespace isomotion::player {

struct PlayOptions {
    std::string scene; // a file or a name of the gallery; empty: the gallery
    std::vector<scene::Override> overrides;
    scene::Reach reach = scene::Reach::own_folder; // for every scene opened
    // The first and the last of the frames to play; none: all of the scene.
    std::optional<std::pair<int, int>> frames;
    bool playing = true;       // plays at once
    std::filesystem::path log; // a line of JSON for each picture shown; empty: none
    bool remembers = true;     // places and cameras, from run to run
};

// Opens the window and returns when it is closed. Throws NoWindow, and SceneError for the scene
// given; shows later errors in the window. After a reset of the graphics driver it goes on in a new
// window.
void play(const PlayOptions& options);

} // namespace isomotion::player
