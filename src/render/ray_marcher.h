// Marches the rays of a tile to their ends, in as many passes as needed.
#pragma once

#include <functional>

#include "gpu/query.h"
#include "gpu/target.h"
#include "render/pass_table.h"
#include "render/scene_plan.h"
#include "scene/scene.h"

namespace isomotion::render {

// Two targets that hold the states of a tile's rays, before and after a pass.
struct RayTargets {
    RayTargets(const shader::Passes& passes, const MarchPlan& tile)
        : even(tile.target_width(), tile.target_height(), passes.state_textures)
        , odd(tile.target_width(), tile.target_height(), passes.state_textures) {}
    gpu::Target even, odd;
};

class RayMarcher {
public:
    // `stop_if_asked` is called between passes; it may throw.
    RayMarcher(const shader::Passes& passes, const scene::Scene& scene, const ScenePlan& plan,
               std::function<void()> stop_if_asked);

    // Marches a tile's rays by the pass with this role: march, mirror or shadow. Returns the target
    // that holds their ends, which is also bound as state textures. `counted_into` is any target as
    // large as a tile; its pixels change. Adds its draws to `draws`. `parts`: as of
    // PassTable::march.
    const gpu::Target& march(PassTable& table, shader::Role role, const gpu::Rectangle& tile,
                             const RayTargets& targets, const gpu::Target& counted_into, int& draws,
                             const gpu::Rectangles* parts = nullptr) const;

private:
    // Evaluations of a ray in one draw: usually, and at most where few rays are open yet.
    struct Evaluations {
        int usual, most;
    };
    Evaluations evaluations_of(shader::Role role) const;

    const shader::Passes& passes_;
    const ScenePlan& plan_;
    int shadow_lights_;
    std::function<void()> stop_if_asked_;
    mutable gpu::SamplesQuery still_active_;
};

} // namespace isomotion::render
