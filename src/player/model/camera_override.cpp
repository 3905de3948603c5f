#include "player/model/camera_override.h"

#include <utility>

namespace isomotion::player {

scene::Scene with_camera(scene::Scene scene, const scene::CameraAt& camera) {
    animation::Animation& own = scene.surfaces.front().animation; // has the camera's tracks
    std::vector<animation::Track> tracks = own.tracks();
    const auto add = [&](const char* name, double value) {
        tracks.push_back({name, value});
        return scene::TrackId(tracks.size() - 1);
    };
    const auto add_vector = [&](const char* name, const glm::dvec3& v) {
        return scene::Vec3Track{add(name, v.x), add(name, v.y), add(name, v.z)};
    };
    scene::Camera held;
    held.projection = camera.projection;
    held.position = add_vector("camera.position", camera.position);
    held.target = add_vector("camera.target", camera.target);
    held.up = add_vector("camera.up", camera.up);
    held.fov = add("camera.fov", camera.fov);
    held.zoom = add("camera.zoom", camera.zoom);
    if (camera.projection == scene::Camera::Projection::orthographic) {
        held.height = add("camera.height", camera.height);
    }
    held.shutter = scene.camera.shutter;
    if (scene.camera.aperture) {
        held.aperture = add("camera.aperture", camera.aperture);
        held.focus = add("camera.focus", camera.focus);
    }
    scene.camera = held;
    own = animation::Animation(std::move(tracks), own.arrays(), own.seed());
    return scene;
}

} // namespace isomotion::player
