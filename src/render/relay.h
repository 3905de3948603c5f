// Two alternating targets: the pass of each surface reads what the passes before it drew.
#pragma once

#include <array>

#include "gpu/target.h"
#include "render/march_plan.h"

namespace isomotion::render {

struct Relay {
    Relay(const MarchPlan& tile, int attachments)
        : targets{gpu::Target(tile.target_width(), tile.target_height(), attachments),
                  gpu::Target(tile.target_width(), tile.target_height(), attachments)} {}

    const gpu::Target& last() const { return targets[std::size_t(at)]; }
    const gpu::Target& next() { return targets[std::size_t(at = 1 - at)]; }

    std::array<gpu::Target, 2> targets;
    int at = 1;
};

} // namespace isomotion::render
