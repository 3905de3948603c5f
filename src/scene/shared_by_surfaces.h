// The settings that all surfaces of a scene share, for a scene and for its state at a time.
#pragma once

namespace isomotion::scene {

// Copies camera, lights, sections and surroundings from one surface to another. `Surface`: a Scene
// or a SceneAt.
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
