// Rays that start where the eye's rays ended: shadow rays, mirrored rays and rays through glass.
#pragma once

#include <optional>

#include "gpu/target.h"
#include "render/glass_paths.h"
#include "render/pass_table.h"
#include "render/ray_marcher.h"

namespace isomotion::render {

// For scenes whose passes keep the ends of rays (Role::surface).
class SecondaryRays {
public:
    SecondaryRays(const shader::Passes& passes, const scene::OneSurface& one,
                  const MarchPlan& tile);

    // Traces the rays that start at the ends of a tile's rays, which are bound as state textures,
    // and binds the results for the shade pass. `counted_into` and `draws`: see RayMarcher.
    void trace(PassTable& table, const RayMarcher& marcher, const gpu::Rectangle& tile,
               const gpu::Target& counted_into, int& draws) const;

private:
    struct Mirror {
        RayTargets rays;
        gpu::Target ends;
        std::optional<RayTargets> shadows; // from these ends
    };

    gpu::Target ends_;
    std::optional<Mirror> mirror_;
    std::optional<GlassPaths> glass_;
    std::optional<RayTargets> shadow_, shadow_through_glass_;
};

} // namespace isomotion::render
