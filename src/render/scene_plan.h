// Divides a scene's pictures into draws by the number of loop iterations in its passes.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "elements/element_grid.h"
#include "render/march_plan.h"
#include "scene/scene.h"
#include "shader/pass.h"

namespace isomotion::render {

struct ScenePlan {
    MarchPlan march;
    // In one draw, for rays that sum over all elements: usually, and where few rays are open yet.
    int evaluations_without_lists = 0, most_evaluations_without_lists = 0;
    std::uint32_t most_elements_at_a_place = 0; // if elements are found by place
    float element_budget = 0; // limit on elements summed in all evaluations of one draw
};

// For each array the number of elements that an evaluation is assumed to sum; in the list of a
// cell, if they are found by place.
std::vector<int> elements_by_place(const shader::Passes& passes);

// Whether lists are so long that some ray will not end in one draw.
bool are_lists_long(const elements::ElementGrid& grid, const ScenePlan& plan);

// `wanted` replaces the march plan made from the formula's cost. Throws std::length_error for a sum
// too long for a shader, and for a formula that no draw can evaluate.
ScenePlan plan_scene(const scene::OneSurface& one, const shader::Passes& passes, int width,
                     int height, int max_texture_size, const std::optional<MarchPlan>& wanted,
                     const DrawLimits& limits = {});

} // namespace isomotion::render
