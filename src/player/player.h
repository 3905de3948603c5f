// The live window: isomotion play.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
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
    // The first and the last of the frames to play; unset: all frames of the scene.
    std::optional<std::pair<int, int>> frames;
    bool playing = true;       // starts playing at once
    std::filesystem::path log; // receives a line of JSON for each picture shown; empty: none
    bool remembers = true;     // keeps places and cameras between runs
    // Called before OpenGL is used; what it returns is kept until the first picture is drawn.
    std::function<std::shared_ptr<void>()> guard = [] { return nullptr; };
};

// Opens the window and returns when it is closed. Throws NoWindow, and SceneError for the given
// scene; the window shows later errors. After a reset of the graphics driver it continues in a new
// window.
void play(const PlayOptions& options);

} // namespace isomotion::player
