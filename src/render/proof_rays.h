// The rays that proofs are of: each as thick as rounding may make it.
#pragma once

#include "render/uniform_blocks.h"

namespace isomotion::render {

// How thick the rays are, and how short pieces get: uniforms of shaders/proof/.
struct RayThickness {
    glm::vec4 tube{0};
    float shortest_piece = 0;
};

struct ProofRays {
    FrameBlock frame; // the frame's, in bounds that are wider by what rounding may do
    glm::vec4 beam{0}, coarse_beam{0}; // of blocks of rays: see beam_range()
    RayThickness of_floats, of_doubles;
    bool in_range = true; // else nothing is known of what float32 makes of them
};

ProofRays proof_rays(const scene::Scene& scene, const scene::SceneAt& now, int width, int height,
                     const scene::Aim& aim);

} // namespace isomotion::render
