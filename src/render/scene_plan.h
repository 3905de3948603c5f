// How a scene's pictures are cut into draws, by what its passes' loops may add up to.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/march_plan.h"
#include "scene/scene.h"
#include "synthesis/pass.h"

namespace isomotion::render {

struct ScenePlan {
    MarchPlan march;
    int evaluations_without_lists = 0;          // of one draw, for rays that go by all elements
    std::uint32_t most_elements_at_a_place = 0; // that are found by place
    float element_budget = 0; // that the evaluations of one draw may go through, all together
};

// Elements of each array that an evaluation is reckoned to go through, in the list of a cell where
// they are found by place.
std::vector<int> elements_by_place(const synthesis::Passes& passes);

// `wanted`: instead of the march plan made from the formula's cost. Throws std::length_error for a
// sum too long for a shader and for a formula that no draw can hold.
ScenePlan plan_scene(const scene::Scene& scene, const synthesis::Passes& passes, int width,
                     int height, int max_texture_size, const std::optional<MarchPlan>& wanted);

} // namespace isomotion::render
