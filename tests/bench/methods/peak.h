// The most arithmetic that the machine does in a shader.
#pragma once

#include "gpu/context.h"
#include "synthesis/stage.h"

namespace isomotion::bench {

// Floating-point operations a second of independent chains of multiply-adds, two operations each:
// the best of several numbers of chains, with and without the function fma.
double peak_operations(gpu::Context& context, synthesis::Stage stage = synthesis::Stage::fragment);

} // namespace isomotion::bench
