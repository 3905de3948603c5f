// A scene opened from its file and reloaded when the file changes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "player/model/file_watch.h"
#include "player/model/session.h"
#include "player/model/timeline_markers.h"
#include "scene/reading/load.h"

namespace isomotion::player {

class LiveScene {
    FileWatch scene_files_; // first, so that files are stamped before they are read

public:
    // Throws as scene::load does.
    LiveScene(const std::string& scene, std::vector<scene::Override> overrides,
              scene::Reach reach = scene::Reach::own_folder);

    Session session;

    const std::filesystem::path& file() const { return session.scene().file; }
    // The file with the scene's topology: beside the scene, or in the user's cache if settings of
    // the command line change the scene.
    std::filesystem::path timeline_file() const;
    // Keys, and topology events.
    const std::vector<TimelineMarker>& markers() const { return markers_; }
    // The topology events among them, with their places.
    const std::vector<PlacedEvent>& events() const { return events_; }
    // Why the timeline file was refused; otherwise empty.
    const std::string& refusal() const { return refusal_; }
    const std::vector<scene::Override>& overrides() const { return overrides_; }
    scene::Reach reach() const { return reach_; }

    // Changes on disk since the last look().
    struct News {
        bool scene = false;   // the scene was reloaded
        bool shaders = false; // compiled shaders are out of date
        bool markers = false;
        // Why the scene's file can no longer be read; then the scene stays as it was. Otherwise
        // empty.
        std::string error;

        bool any() const { return scene || shaders || markers || !error.empty(); }
    };
    News look(double now);

private:
    void read_markers();
    std::vector<std::filesystem::path> timeline_files() const;

    std::vector<scene::Override> overrides_;
    scene::Reach reach_;
    std::vector<TimelineMarker> markers_;
    std::vector<PlacedEvent> events_;
    std::string refusal_;
    FileWatch shader_files_, timeline_;
};

} // namespace isomotion::player
