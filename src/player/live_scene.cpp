#include "player/live_scene.h"

#include <exception>

namespace isomotion::player {

LiveScene::LiveScene(const std::string& scene, std::vector<scene::Override> overrides)
    : session(scene::load(scene, overrides))
    , overrides_(std::move(overrides))
    , shader_files_(shader_files())
    , timeline_({timeline_path(session.scene())}) {
    watch();
    read_marks();
}

void LiveScene::watch() { scene_files_.watch(files_of(session.scene())); }

void LiveScene::read_marks() {
    marks_ = session.key_marks();
    TopologyMarks topology = read_topology_marks(session.scene());
    marks_.insert(marks_.end(), topology.marks.begin(), topology.marks.end());
    refusal_ = std::move(topology.refusal);
}

LiveScene::News LiveScene::look(double now) {
    News news;
    news.shaders = !shader_files_.changed().empty();
    if (!scene_files_.changed().empty()) {
        try {
            session.reload(scene::load(file().string(), overrides_), now);
            news.scene = true;
            watch();
        } catch (const std::exception& error) {
            news.error = error.what();
        }
    }
    if (!timeline_.changed().empty() || news.scene) {
        read_marks();
        news.marks = true;
    }
    return news;
}

} // namespace isomotion::player
