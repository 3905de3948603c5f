// The surfaces of a scene, by name and alone.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace isomotion::scene {

inline constexpr int most_surfaces = 8;

// A scene of this surface only, with the settings that all share as they are for it: its own
// parameters move them. They must be those that were read.
Scene alone(const OneSurface& one);

// A bit for each surface that mirrors all surfaces.
int mirrors(const Scene& scene);
// The surfaces of glass, the one whose matter counts before all others first; and the largest of
// their depths.
std::vector<std::size_t> matters(const Scene& scene);
int depth_of_matters(const Scene& scene);

std::vector<std::string> surface_names(const Scene& scene);
// The index of the surface with that name, given by an option of the command line. Throws
// SceneError that lists the names if there is none.
std::size_t surface_named(const Scene& scene, const std::string& name,
                          const std::string& option = "--surface");

// Where the file states what belongs to a surface, for messages: "ring.toml:9: material.color", or
// of one among several "ring.toml:9: surfaces.ball.material.color", as --set calls it. `name`: see
// value_places.h.
std::string place_of(const OneSurface& one, const std::string& name);

// The settings of one surface after those of the first one have changed from `before` to `now`.
// Lengths and values of each surface's own change by the same factor; what has not changed stays.
Isolation changed_alike(Isolation other, const Isolation& before, const Isolation& now);

} // namespace isomotion::scene
