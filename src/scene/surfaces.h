// Scenes with several surfaces.
//
// Each surface has its own formula, bounds, placement, material and method. Camera, lights,
// sections, surroundings and output are those of the first, which represents the scene.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace isomotion::scene {

inline constexpr int most_surfaces = 8;

// One surface, with the shared settings that the first one has now.
Scene of_surface(const Scene& scene, int index);
// The same surface as a scene of its own.
Scene alone(const Scene& scene, int index);

std::vector<std::string> surface_names(const Scene& scene);
// The index of the surface with that name, given by an option of the command line. Throws
// SceneError that lists the names if there is none.
int surface_named(const Scene& scene, const std::string& name,
                  const std::string& option = "--surface");

// Where the file states what belongs to a surface, for messages: "ring.toml:9: material.color", or
// of one among several "ring.toml:9: surfaces.ball.material.color", as --set calls it. `name`: see
// value_places.h.
std::string place_of(const Scene& surface, const std::string& name);

// Throws SceneError if there are several surfaces. `who` needs a single one: "a page".
void expect_one_surface(const Scene& scene, const std::string& who);

// The settings of one surface after those of the first one have changed from `before` to `now`.
// Lengths and values of each surface's own change by the same factor; what has not changed stays.
Isolation changed_alike(Isolation other, const Isolation& before, const Isolation& now);

} // namespace isomotion::scene
