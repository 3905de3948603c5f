// The channel velocity of a tile, see motion.h: evaluates F at two other times where the rays
// ended.
#pragma once

#include <span>
#include <vector>

#include "gpu/target.h"
#include "render/march_plan.h"
#include "render/motion.h"
#include "render/pass_table.h"
#include "render/record.h"

namespace isomotion::render {

class VelocityPass {
public:
    explicit VelocityPass(const MarchPlan& tile)
        : field_(tile.tile_width, tile.tile_height) {}

    // The gradient and the value of F at another time, whose parameters and elements are uploaded,
    // where the bound rays ended: four floats per pixel. `from` holds the formula coordinates of
    // these ends, `to` those of the other time. On caps the gradient and the value are their
    // section's.
    std::vector<float> field_there(PassTable& table, const gpu::Rectangle& tile,
                                   const scene::PlacementAt& from,
                                   const scene::OneSurfaceAt& to) const;

private:
    gpu::Target field_;
};

// The velocity at each pixel of a tile, 0 without a hit; see velocity() of motion.h. `record` is
// the tile's. `rays`, `before` and `after` have four floats per pixel: t comes first in `rays`; the
// others are VelocityPass's results for both times of the motion.
std::vector<glm::dvec3> velocities(const SurfaceMotion& motion, int width, int height,
                                   const gpu::Rectangle& tile, const Record& record,
                                   std::span<const float> rays, std::span<const float> before,
                                   std::span<const float> after);

} // namespace isomotion::render
