// A scene for WebGL2: its passes in GLSL ES and the plan that divides pictures into draws.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "render/scene_plan.h"
#include "scene/scene.h"
#include "shader/beam_copies_text.h"
#include "shader/pass.h"

namespace isomotion::page {

// Limits of a page: elements that its shaders sum at every place, elements found by place, and the
// values of all frames, unpacked.
inline constexpr int most_elements = 1000, most_elements_by_place = 20'000;
inline constexpr std::size_t most_value_bytes = 32'000'000;
// Pixels along the sides of a tile, which one draw fills; this limits the time for which a browser
// is blocked.
inline constexpr int largest_tile = shader::tile_of_copies;

// One surface of a scene, whose passes begin where those of the ones before have ended.
struct WebSurface {
    scene::OneSurface one;
    shader::Passes passes;
    render::ScenePlan plan; // of a tile
};

struct WebScene {
    std::shared_ptr<const scene::Scene> scene; // without proofs, for which GLSL ES lacks `precise`
    std::vector<WebSurface> surfaces;          // in the file's order
};

// Throws SceneError ("file:line: key: what is wrong, what would be right") for a scene that a page
// cannot show, and std::length_error for a sum too long for a shader.
WebScene web_scene(scene::Scene scene);

} // namespace isomotion::page
