// The light of a tile's pixels on its way through glass.
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
    // `depth`: how many rays follow the eye's.
    GlassPaths(const synthesis::Passes& passes, const MarchPlan& tile, int depth);

    // Follows the paths that begin on the ends of the eye's rays, which are bound as surface
    // textures and as state textures, and binds what they brought. Adds its draws to `draws`.
    void trace(PassTable& table, const RayMarcher& marcher, const gpu::Rectangle& tile,
               int& draws) const;
    // What they met of the ground, as ends of rays; of scenes with Role::glass_ground.
    const gpu::Target& draw_ground(PassTable& table, const gpu::Rectangle& tile) const;

private:
    bool any_goes_on(PassTable& table, const gpu::Rectangle& tile) const;

    int depth_;
    RayTargets rays_;
    gpu::Target kept_, gone_on_; // all paths, and those that a ray took on
    gpu::DepthMask mask_;        // where paths go on
    std::optional<gpu::Target> ground_;
    mutable gpu::SamplesQuery still_active_;
};

} // namespace isomotion::render
