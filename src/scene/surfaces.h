// The surfaces of a scene with several.
//
// Each has a formula, bounds, a placement, a material and a method of its own. Camera, lights,
// sections, surroundings and output are the first one's, which stands for the scene.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace isomotion::scene {

inline constexpr int most_surfaces = 8;

// A surface among the others, with what all share as the first one has it now.
Scene of_surface(const Scene& scene, int index);
// The same surface in a scene of its own.
Scene alone(const Scene& scene, int index);

std::vector<std::string> surface_names(const Scene& scene);
// The index of that name; throws SceneError for none, with the names that there are.
int surface_named(const Scene& scene, const std::string& name);

// Throws SceneError where there are several. `who`: what can do with one alone, as "a page".
void expect_one_surface(const Scene& scene, const std::string& who);

} // namespace isomotion::scene
