// Data that the player keeps between runs: the window's place and the camera of each scene, and the
// list of scenes opened.
//
// They are JSON files in $XDG_STATE_HOME/isomotion (XDG Base Directory Specification; by default
// ~/.local/state/isomotion): history.json, and in scenes/ one file per scene, named by a
// fingerprint of the scene's path. A file is replaced as a whole and never visible half-written. A
// file that can't be read or written only causes a warning.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene_at.h"

namespace isomotion::player {

// Called once for each failure: "FILE: why".
using Warn = std::function<void(const std::string&)>;

struct WindowPlace {
    int x = 0, y = 0; // of the upper left corner, screen coordinates
    int width = 0, height = 0;
    bool maximised = false;

    bool operator==(const WindowPlace&) const = default;
};

// A part of the desktop that windows may use.
struct WorkArea {
    int x = 0, y = 0, width = 0, height = 0;
};
// Moves the place into the area that it overlaps most, otherwise into the first; shrinks it if
// necessary.
WindowPlace within(WindowPlace place, const std::vector<WorkArea>& areas);

struct SceneMemory {
    std::optional<WindowPlace> window;
    std::optional<scene::CameraAt> camera; // as a person moved it; unset: the scene's own
};

class Memory {
public:
    // Keeps its files in `folder`. With an empty path it keeps nothing.
    explicit Memory(std::filesystem::path folder, Warn warn = {});

    SceneMemory recall(const std::filesystem::path& scene) const;
    void remember(const std::filesystem::path& scene, const SceneMemory& memory) const;

    // Scenes opened before, the newest first, at most most_opened, without those whose files no
    // longer exist.
    std::vector<std::filesystem::path> opened() const;
    // Puts a scene at the front.
    void add_opened(const std::filesystem::path& scene) const;

    static constexpr std::size_t most_opened = 20;

private:
    std::filesystem::path file_of(const std::filesystem::path& scene) const;

    std::filesystem::path folder_;
    Warn warn_;
};

// Taken from the environment; empty if neither XDG_STATE_HOME nor HOME is an absolute path.
std::filesystem::path state_folder();
// For files that can be regenerated: XDG_CACHE_HOME, otherwise ~/.cache.
std::filesystem::path cache_folder();

} // namespace isomotion::player
