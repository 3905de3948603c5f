// A scene as WebGL2 draws it: its passes in GLSL ES and how pictures are cut into draws of them.
#pragma once

#include <cstddef>

#include "render/scene_plan.h"
#include "scene/scene.h"
#include "synthesis/pass.h"

namespace isomotion::page {

// What a page holds at most: of elements that its shaders go through at every place, and of those
// that they find by place; of the values of all frames, unpacked.
inline constexpr int most_elements = 1000, most_elements_by_place = 20'000;
inline constexpr std::size_t most_value_bytes = 32'000'000;
// Pixels along the sides of a tile, which one draw fills: a browser is not kept longer than that.
inline constexpr int largest_tile = 512;

struct WebScene {
    scene::Scene scene; // without proofs, for which GLSL ES has no `precise`
    synthesis::Passes passes;
    render::ScenePlan plan; // of a tile
};

// Throws SceneError ("file: what is wrong, what would be right") for what a page cannot show, and
// std::length_error for a sum too long for a shader.
WebScene web_scene(scene::Scene scene);

} // namespace isomotion::page
