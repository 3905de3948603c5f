// The shaders of scenes that call for more than one plain light: where rays ended is kept, further
// rays start there, and the picture is shaded from all of it.
#pragma once

#include "scene/scene.h"
#include "synthesis/shader_text.h"

namespace isomotion::synthesis {

// A bit for each light that casts shadows.
int shadow_mask(const scene::Scene& scene);
int far_lights(const scene::Scene& scene);

// The parts of the shade pass after rays, shading.glsl and surface_color(): the generated shade().
void add_shading(ShaderText& text, const scene::Scene& scene);
// light_at().
// The same of what is seen in a mirror of one surface among several: seen_again().
void add_seen_shading(ShaderText& text, const scene::Scene& scene);
void add_lights(ShaderText& text, const scene::Scene& scene);

} // namespace isomotion::synthesis
