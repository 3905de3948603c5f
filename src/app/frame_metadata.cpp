#include "app/frame_metadata.h"

namespace isomotion::app {
namespace {

std::vector<double> components(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

} // namespace

image::Metadata frame_metadata(const scene::Scene& scene, const scene::SceneAt& now,
                               const animation::Values& values, int frame,
                               const std::string& fingerprint) {
    const auto& fps = scene.timeline.fps;
    const scene::Isolation& isolation = scene.isolation;
    image::Metadata metadata{
        {"FramesPerSecond", image::Rational{fps.numerator, fps.denominator}},
        {"Software", std::string("isomotion " ISOMOTION_VERSION)},
        {"isomotion:title", scene.title},
        {"isomotion:frame", frame},
        {"isomotion:time", values.time},
        {"isomotion:formula", scene.surface.field->text},
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
    for (int k = 0; k < scene.surface.parameters; ++k) {
        const auto index = std::size_t(k);
        metadata.push_back({"isomotion:parameter." + scene.timeline.animation.tracks()[index].name,
                            values.tracks[index]});
    }
    metadata.push_back({fingerprint_key, fingerprint});
    return metadata;
}

} // namespace isomotion::app
