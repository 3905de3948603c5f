// What all surfaces of a scene share, of a scene and of its state at a time.
#pragma once

namespace isomotion::scene {

// Gives one surface what another has of camera, lights, sections and surroundings. `Surface`: a
// Scene or a SceneAt.
template<class Surface> void share_surroundings(const Surface& from, Surface& to) {
    to.camera = from.camera;
    to.lights = from.lights;
    to.sections = from.sections;
    to.ground = from.ground;
    to.fog = from.fog;
    to.ambient = from.ambient;
    to.occlusion = from.occlusion;
    to.environment = from.environment;
}

} // namespace isomotion::scene
