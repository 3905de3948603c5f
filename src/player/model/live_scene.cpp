#include "player/model/live_scene.h"

#include <exception>

#include "player/model/memory.h"
#include "scene/data_folder.h"
#include "scene/surfaces.h"
#include "topology/timeline/timeline_header.h"

namespace isomotion::player {

namespace fs = std::filesystem;

namespace {

bool is_there(const std::string& file) {
    std::error_code ignored;
    return fs::exists(file, ignored);
}

} // namespace

LiveScene::LiveScene(const std::string& scene, std::vector<scene::Override> overrides,
                     scene::Reach reach)
    : scene_files_(files_named(is_there(scene) ? fs::path(scene) : scene::animation_file(scene)))
    , session(scene::load(scene, overrides, reach))
    , overrides_(std::move(overrides))
    , reach_(reach)
    , shader_files_(shader_files())
    , timeline_(timeline_files()) {
    scene_files_.watch(files_of(session.scene()));
    read_markers();
}

fs::path LiveScene::timeline_file() const {
    const fs::path cache = cache_folder();
    const bool has_file = session.scene().formula.empty();
    if ((overrides_.empty() && has_file) || cache.empty()) return timeline_path(session.scene());
    return cache / "timelines" / (topology::fingerprint({session.scene(), 0}) + ".timeline.json");
}

std::vector<fs::path> LiveScene::timeline_files() const {
    const scene::Scene& scene = session.scene();
    if (scene.surfaces.size() == 1) return {timeline_file()};
    std::vector<fs::path> files;
    for (const std::string& name : scene::surface_names(scene))
        files.push_back(timeline_path(scene, name));
    return files;
}

void LiveScene::read_markers() {
    markers_ = session.key_markers();
    // Settings may leave the topology as it is: then what lies beside the scene is right, too.
    const fs::path own = timeline_file();
    std::error_code ignored;
    TopologyMarkers topology =
        session.scene().surfaces.size() > 1
            ? read_topology_markers_of_each(session.scene())
            : read_topology_markers(
                  session.scene(), fs::exists(own, ignored) ? own : timeline_path(session.scene()));
    markers_.insert(markers_.end(), topology.markers.begin(), topology.markers.end());
    events_ = std::move(topology.events);
    refusal_ = std::move(topology.refusal);
}

LiveScene::News LiveScene::look(double now) {
    News news;
    news.shaders = !shader_files_.changed().empty();
    if (!scene_files_.changed().empty()) {
        // The files that the text names now are watched, too: if one of them makes the scene fail,
        // mending that file mends the scene.
        scene_files_.watch(files_of(session.scene()));
        try {
            session.reload(scene::load(scene::reload_argument(session.scene()), overrides_, reach_),
                           now);
            news.scene = true;
            scene_files_.watch(files_of(session.scene()));
            timeline_.watch(timeline_files());
        } catch (const std::exception& error) {
            news.error = error.what();
        }
    }
    if (!timeline_.changed().empty() || news.scene) {
        read_markers();
        news.markers = true;
    }
    return news;
}

} // namespace isomotion::player
