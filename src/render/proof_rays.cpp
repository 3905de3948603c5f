#include "render/proof_rays.h"

#include <algorithm>

#include "synthesis/proof_text.h"

namespace isomotion::render {

ProofRays proof_rays(const scene::Scene& scene, const scene::SceneAt& now, int width, int height,
                     const scene::Aim& aim) {
    const scene::Rays rays = scene::rays(now, width, height, aim);
    const double footprint = 2 * glm::length(rays.up) / height;
    ProofRays found;
    // Of truth's tubes what a point may be off by, four times over: the rays here and those marched
    // are each within once that of the exact one, which the rays in doubles are but for 2^-40 of
    // it.
    found.beam = beam_range(now, width, height, aim, synthesis::proved_block);
    const double margin = found.beam.w;
    const double spread = glm::length(rays.right) + glm::length(rays.up);
    const double direction =
        16 * 0x1p-24 * (1 + (rays.parallel ? 0 : spread / glm::length(rays.axis)));
    const auto shortest = float(std::max(margin, footprint / 256));
    found.of_floats = {glm::vec4(0.55 * margin, 3 * direction, margin, footprint / 8), shortest};
    found.of_doubles = {glm::vec4(0.26 * margin, 1.01 * direction, margin, footprint / 8),
                        shortest};

    found.frame = frame_block(scene, now, width, height, aim);
    const auto more = float(margin);
    if (now.bounds.shape == scene::Bounds::Shape::sphere) {
        found.frame.bounds_min.w += more;
    } else {
        found.frame.bounds_min -= more;
        found.frame.bounds_max += more;
    }
    return found;
}

} // namespace isomotion::render
