// A scene opened from its file, which is read again when it changes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "player/marks.h"
#include "player/session.h"
#include "player/watch.h"
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
    // Where what is known of the topology is kept: beside the scene; with settings of the command
    // line, which make it another scene, in the user's cache.
    std::filesystem::path timeline_file() const;
    // Keys, and what is known of the topology.
    const std::vector<Mark>& marks() const { return marks_; }
    // Why a timeline file beside the scene is of no use; else empty.
    const std::string& refusal() const { return refusal_; }
    const std::vector<scene::Override>& overrides() const { return overrides_; }
    scene::Reach reach() const { return reach_; }

    // What look() found, asked now and then.
    struct News {
        bool scene = false;   // read again
        bool shaders = false; // have changed: what was compiled is old
        bool marks = false;
        // Why the scene cannot be read as it is now; the one before is kept. Empty: it can.
        std::string error;

        bool any() const { return scene || shaders || marks || !error.empty(); }
    };
    News look(double now);

private:
    void read_marks();

    std::vector<scene::Override> overrides_;
    scene::Reach reach_;
    std::vector<Mark> marks_;
    std::string refusal_;
    FileWatch shader_files_, timeline_;
};

} // namespace isomotion::player
