// Measures the cost of each effect that a scene uses.
#pragma once

#include <vector>

#include "gpu/context.h"
#include "render/stage.h"
#include "shader/effect.h"

namespace isomotion::accuracy {

struct EffectPrice {
    shader::Effect effect;
    double with = 0, without = 0; // ms per frame, medians
    double price = 0;             // ms: the median of the differences of paired runs
};

// Draws a frame with all effects and without each of them in turn, `pairs` times, one right after
// the other, so that other load of the machine affects both equally.
std::vector<EffectPrice> effect_prices(gpu::Context& context, const scene::Scene& scene, int frame,
                                       int width, int height, int pairs,
                                       render::StageChoice stage = render::StageChoice::fragment);

} // namespace isomotion::accuracy
