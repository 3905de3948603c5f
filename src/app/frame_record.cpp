#include "app/frame_record.h"

#include <algorithm>

#include "sequence/scene_fingerprint.h"

namespace isomotion::app {
namespace {

std::vector<std::string> layers(const std::vector<synthesis::Channel>& channels) {
    std::vector<std::string> names{"R", "G", "B", "A"};
    for (const auto& entry : synthesis::channel_names()) {
        if (std::ranges::find(channels, entry.channel) == channels.end()) continue;
        names.insert(names.end(), entry.layers.begin(), entry.layers.end());
    }
    return names;
}

} // namespace

sequence::Sequence sequence_of(const scene::Scene& scene, const image::SequenceName& name,
                               image::Format format,
                               const std::vector<synthesis::Channel>& channels,
                               std::vector<int> frames, const gpu::ContextInfo& driver,
                               synthesis::Stage stage, const std::string& shaders_fingerprint) {
    sequence::Sequence all;
    all.title = scene.title;
    all.scene_file = scene.file.filename().string();
    all.backend = driver.backend;
    all.making = {sequence::scene_fingerprint(scene), shaders_fingerprint, ISOMOTION_VERSION,
                  driver.renderer + ", OpenGL " + driver.version, std::string(render::name(stage))};
    all.shape = {name.pattern(),      scene.output.width,
                 scene.output.height, std::string(image::name(format)),
                 layers(channels),    animation::to_string(scene.timeline.fps)};
    all.asked = std::move(frames);
    std::ranges::sort(all.asked);
    return all;
}

sequence::FrameRecord record_of(const scene::Scene& scene, int frame,
                                const animation::Values& values, const render::Picture& picture) {
    sequence::FrameRecord record;
    record.frame = frame;
    record.time = values.time;
    for (std::size_t k = 0; k < std::size_t(scene.surface.parameters); ++k) {
        record.parameters.emplace_back(scene.timeline.animation.tracks()[k].name, values.tracks[k]);
    }
    record.verdicts = picture.verdicts;
    if (scene.isolation.certify) record.proofs = picture.proofs;
    record.evaluations = picture.evaluations;
    record.drawing = picture.drawing.count();
    return record;
}

} // namespace isomotion::app
