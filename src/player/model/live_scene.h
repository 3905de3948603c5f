// A scene opened from its file, which is read again when it changes.
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
    FileWatch scene_files_; // first: files are stamped before they are read

public:
    // Throws as scene::load does.
    LiveScene(const std::string& scene, std::vector<scene::Override> overrides,
              scene::Reach reach = scene::Reach::own_folder);

    Session session;

    const std::filesystem::path& file() const { return session.scene().file; }
    // The file with the scene's topology: beside the scene; in the user's cache where settings of
    // the command line make it another scene.
    std::filesystem::path timeline_file() const;
    // Keys, and topology events.
    const std::vector<TimelineMarker>& markers() const { return markers_; }
    // Why the timeline file was refused; else empty.
    const std::string& refusal() const { return refusal_; }
    const std::vector<scene::Override>& overrides() const { return overrides_; }
    scene::Reach reach() const { return reach_; }

    // What has changed on disk since the last look().
    struct News {
        bool scene = false;   // the scene was read again
        bool shaders = false; // compiled shaders are out of date
        bool markers = false;
        // Why the scene's file cannot be read any more; the scene stays as it was. Else empty.
        std::string error;

        bool any() const { return scene || shaders || markers || !error.empty(); }
    };
    News look(double now);

private:
    void read_markers();

    std::vector<scene::Override> overrides_;
    scene::Reach reach_;
    std::vector<TimelineMarker> markers_;
    std::string refusal_;
    FileWatch shader_files_, timeline_;
};

} // namespace isomotion::player
