// One pass of a tile's rays: each goes on from its state by a bounded number of evaluations.
#pragma once

#include "gpu/draw.h"
#include "gpu/program.h"
#include "gpu/target.h"
#include "synthesis/assemble.h"

namespace isomotion::render {

// A shader of rays, of the stage that `shaders` were assembled for.
gpu::Program ray_program(const synthesis::Shaders& shaders, const std::string& text,
                         const char* label);

// Runs such a program once for every pixel of the lower left width x height of `into`, which takes
// the states.
void run_ray_pass(synthesis::Stage stage, const gpu::Program& program, const gpu::Target& into,
                  int width, int height, const gpu::Fullscreen& triangle);

} // namespace isomotion::render
