// The rays that proofs cover, thickened by the possible rounding.
#pragma once

#include "render/uniform_blocks.h"

namespace isomotion::render {

// Thickness of the rays and length of the shortest pieces: uniforms of shaders/proof/.
struct RayThickness {
    glm::vec4 tube{0};
    float shortest_piece = 0;
};

struct ProofRays {
    FrameBlock frame;                  // the frame's block with bounds widened by the rounding
    glm::vec4 beam{0}, coarse_beam{0}; // for blocks of rays: see beam_range()
    RayThickness of_floats, of_doubles;
    bool in_range = true; // if false, the rounding of rays in float32 is unknown
    // Among several surfaces: how far behind the place of another's root there must be none.
    float beyond = 0;
};

ProofRays proof_rays(const scene::OneSurface& one, const scene::OneSurfaceAt& now, int width,
                     int height, const scene::Aim& aim);

} // namespace isomotion::render
