// The channel velocity of a tile, see motion.h: F at two other times, where its rays ended.
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

    // The gradient and the value of F, whose parameters and elements at another time are uploaded,
    // where the rays that are bound ended: four floats a pixel. That is, in formula coordinates, at
    // `from`, and in those of the other time at `to`. On caps it is their section's.
    std::vector<float> field_there(PassTable& table, const gpu::Rectangle& tile,
                                   const scene::PlacementAt& from, const scene::SceneAt& to) const;

private:
    gpu::Target field_;
};

// The velocity at each pixel of a tile, 0 where it has no hit; see velocity() of motion.h.
// `record`: of the tile. `rays`, `before` and `after` are four floats a pixel: first t, and what
// VelocityPass told of both times of the motion.
std::vector<glm::dvec3> velocities(const Motion& motion, const scene::SceneAt& now, int width,
                                   int height, const gpu::Rectangle& tile, const Record& record,
                                   std::span<const float> rays, std::span<const float> before,
                                   std::span<const float> after);

} // namespace isomotion::render
