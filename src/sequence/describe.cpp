#include "sequence/describe.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/fingerprint.h"
#include "sequence/scene_fingerprint.h"

namespace isomotion::sequence {
namespace {

std::vector<double> components(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

image::Entry rate(const animation::FrameRate& fps) {
    const image::Rational ratio{fps.numerator, fps.denominator};
    const bool fits = std::max(ratio.numerator, ratio.denominator) <= INT32_MAX;
    if (fits) return {"FramesPerSecond", ratio};
    return {"isomotion:fps", image::to_text(ratio)};
}

std::vector<std::string> layers(const std::vector<shader::Channel>& channels) {
    std::vector<std::string> names{"R", "G", "B", "A"};
    for (const auto& entry : shader::channel_names()) {
        if (std::ranges::find(channels, entry.channel) == channels.end()) continue;
        names.insert(names.end(), entry.layers.begin(), entry.layers.end());
    }
    return names;
}

std::vector<std::pair<std::string, double>> parameters(const scene::Surface& surface,
                                                       const scene::SurfaceAt& now) {
    std::vector<std::pair<std::string, double>> found;
    for (std::size_t k = 0; k < std::size_t(surface.parameters); ++k)
        found.emplace_back(surface.animation.tracks()[k].name, now.values->tracks[k]);
    return found;
}

} // namespace

image::Metadata frame_metadata(const scene::Scene& scene, const scene::SceneAt& now, int frame,
                               image::Format format) {
    const scene::Surface& first = scene.surfaces.front();
    const scene::Isolation& isolation = first.isolation;
    image::Metadata metadata{
        rate(scene.timeline.fps),
        {"Software", std::string("isomotion " ISOMOTION_VERSION)},
        {"isomotion:title", scene.title},
        {"isomotion:frame", frame},
        {"isomotion:time", now.time},
        {"isomotion:formula", first.field->text},
        {"isomotion:method", std::string(scene::name(isolation.method))},
        {"isomotion:step", isolation.step},
        {"isomotion:near", isolation.near},
        {"isomotion:far", isolation.far},
        {"isomotion:horizon", isolation.horizon},
        {"isomotion:bisections", isolation.bisections},
        {"isomotion:safety", isolation.safety},
        {"isomotion:camera.position", components(now.camera.position)},
        {"isomotion:camera.target", components(now.camera.target)},
        {"isomotion:camera.up", components(now.camera.up)},
    };
    if (now.camera.zoom != 1) metadata.push_back({"isomotion:camera.zoom", now.camera.zoom});
    if (now.camera.projection == scene::Camera::Projection::orthographic) {
        metadata.push_back({"isomotion:camera.height", now.camera.height});
    } else {
        metadata.push_back({"isomotion:camera.fov", now.camera.fov});
    }
    if (const int samples = scene.output.samples; samples > 1) {
        metadata.push_back({"isomotion:samples", samples});
        metadata.push_back({"isomotion:camera.shutter", scene.camera.shutter});
        metadata.push_back({"isomotion:camera.aperture", now.camera.aperture});
        metadata.push_back({"isomotion:camera.focus", now.camera.focus});
    }
    // Names of the scene's own may be longer than a format knows.
    const auto add = [&](std::string name, image::Value value) {
        if (name.size() <= image::longest_name(format))
            metadata.push_back({std::move(name), std::move(value)});
    };
    for (auto& [parameter, value] : parameters(first, now.surfaces.front()))
        add("isomotion:parameter." + parameter, value);
    for (const scene::Surface& other : std::span(scene.surfaces).subspan(1))
        add("isomotion:formula." + other.label, other.field->text);
    metadata.push_back({fingerprint_key, std::string()});
    return metadata;
}

std::string file_fingerprint(const std::string& pixels, const std::string& renderer,
                             image::Format format, const image::Metadata& metadata) {
    base::Fingerprint print;
    print.add(pixels).add(renderer).add(ISOMOTION_VERSION).add(std::to_string(int(format)));
    for (const auto& entry : metadata) print.add(entry.name).add(image::to_text(entry.value));
    return print.text();
}

Sequence sequence_of(const scene::Scene& scene, const SequenceName& name, image::Format format,
                     const std::vector<shader::Channel>& channels, std::vector<int> frames,
                     const gpu::ContextInfo& driver, shader::Stage stage,
                     const std::string& shaders_fingerprint) {
    Sequence all;
    all.title = scene.title;
    all.scene_file = scene.file.filename().string();
    all.backend = driver.backend;
    all.provenance = {scene_fingerprint(scene), shaders_fingerprint, ISOMOTION_VERSION,
                      driver.renderer + ", OpenGL " + driver.version,
                      std::string(render::name(stage))};
    all.format = {name.pattern(),      scene.output.width,
                  scene.output.height, std::string(image::name(format)),
                  layers(channels),    animation::to_string(scene.timeline.fps)};
    all.asked = std::move(frames);
    std::ranges::sort(all.asked);
    return all;
}

FrameRecord record_of(const scene::Scene& scene, int frame, const scene::SceneAt& now,
                      const render::Picture& picture) {
    FrameRecord record;
    record.frame = frame;
    record.time = now.time;
    record.parameters = parameters(scene.surfaces.front(), now.surfaces.front());
    record.verdicts = picture.verdicts;
    if (scene.surfaces.front().isolation.certify) record.proofs = picture.proofs;
    record.without_colour = image::count_without_colour(picture.frame);
    record.evaluations = picture.evaluations();
    record.by_kind = render::each(picture.rays, &render::RayCount::evaluations);
    record.most_of_a_pixel = render::each(picture.rays, &render::RayCount::most);
    record.undecided = render::each(picture.rays, &render::RayCount::undecided);
    record.drawing = picture.drawing.count();
    return record;
}

} // namespace isomotion::sequence
