// What the window remembers from one day to the next: for each scene its place and its camera, and
// which scenes were opened.
//
// JSON files in $XDG_STATE_HOME/isomotion (XDG Base Directory Specification; else
// ~/.local/state/isomotion): history.json, and in scenes/ one file a scene, named by a fingerprint
// of the scene's path. They are replaced as a whole and never seen half written. Nothing here is
// worth a failure: what can't be read is forgotten with a warning, and so is what can't be written.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene_at.h"

namespace isomotion::player {

// Told once for each thing that went wrong: "FILE: why".
using Warn = std::function<void(const std::string&)>;

struct WindowPlace {
    int x = 0, y = 0; // of the upper left corner, screen coordinates
    int width = 0, height = 0;
    bool maximised = false;

    bool operator==(const WindowPlace&) const = default;
};

// A rectangle of the desktop that windows may take.
struct WorkArea {
    int x = 0, y = 0, width = 0, height = 0;
};
// The place within the area that it shares most with, or else the first: smaller if it must be.
WindowPlace within(WindowPlace place, const std::vector<WorkArea>& areas);

struct SceneMemory {
    std::optional<WindowPlace> window;
    std::optional<scene::CameraAt> camera; // moved by hand; none: the scene's own
};

class Memory {
public:
    // In this folder; an empty path remembers nothing and knows nothing.
    explicit Memory(std::filesystem::path folder, Warn warn = {});

    SceneMemory recall(const std::filesystem::path& scene) const;
    void remember(const std::filesystem::path& scene, const SceneMemory& memory) const;

    // Scenes opened, the newest first, at most most_opened; those whose files are gone are left
    // out.
    std::vector<std::filesystem::path> opened() const;
    // Puts a scene at the front.
    void add_opened(const std::filesystem::path& scene) const;

    static constexpr std::size_t most_opened = 20;

private:
    std::filesystem::path file_of(const std::filesystem::path& scene) const;

    std::filesystem::path folder_;
    Warn warn_;
};

// By the environment; empty where neither XDG_STATE_HOME nor HOME is an absolute path.
std::filesystem::path state_folder();
// Of what can be made anew: by XDG_CACHE_HOME, else ~/.cache.
std::filesystem::path cache_folder();

} // namespace isomotion::player
