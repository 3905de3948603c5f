// Rays that start where the eye's rays ended: shadow rays and mirrored ones and
// those through glass.
#pragma once

#include <optional>

#include "gpu/target.h"
#include "render/glass_paths.h"
#include "render/pass_table.h"
#include "render/ray_marcher.h"

namespace isomotion::render {

// For scenes whose passes keep where rays ended (Role::surface).
class SecondaryRays {
public:
    SecondaryRays(const synthesis::Passes& passes, const scene::Scene& scene,
                  const MarchPlan& tile);

    // Traces what starts on the ends of a tile's rays, which are bound as state textures, and binds
    // what the shade pass reads of it. `counted_into` and `draws`: as RayMarcher has them.
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
