// Traces the light of a tile's pixels through glass.
#pragma once

#include <optional>

#include "gpu/depth_mask.h"
#include "gpu/query.h"
#include "gpu/target.h"
#include "render/pass_table.h"
#include "render/ray_marcher.h"

namespace isomotion::render {

// For scenes whose passes have Role::glass.
class GlassPaths {
public:
    // `depth`: the number of rays after the primary ray.
    GlassPaths(const shader::Passes& passes, const MarchPlan& tile, int depth);

    // Follows the paths that begin where the eye's rays ended; these are bound as surface textures
    // and as state textures. Binds the resulting light. Adds its draws to `draws`.
    void trace(PassTable& table, const RayMarcher& marcher, const gpu::Rectangle& tile,
               int& draws) const;
    // The points where paths met the ground, as ends of rays; null without Role::glass_ground.
    const gpu::Target* draw_ground(PassTable& table, const gpu::Rectangle& tile) const;

private:
    bool any_goes_on(PassTable& table, const gpu::Rectangle& tile) const;

    int depth_;
    RayTargets rays_;
    gpu::Target kept_, gone_on_; // all paths, and those that a ray continued
    gpu::DepthMask mask_;        // where paths continue
    std::optional<gpu::Target> ground_;
    mutable gpu::SamplesQuery still_active_;
};

} // namespace isomotion::render
