// The shaders of scenes that call for more than one plain light: where rays ended is kept, further
// rays start there, and the picture is shaded from all of it.
#pragma once

#include <optional>

#include "formula/field.h"
#include "scene/scene.h"
#include "synthesis/shader_text.h"

namespace isomotion::synthesis {

// A bit for each light that casts shadows.
int shadow_mask(const scene::Scene& scene);
int far_lights(const scene::Scene& scene);

// Whether mirrors show an environment map, blurred by their roughness and by what a pixel sees.
bool mirrors_environment(const scene::Scene& scene);
// The field's second derivatives, by which the shade pass knows how the normal turns within a
// pixel: of a scene that mirrors an environment, unless they are too long for a shader.
std::optional<formula::Program> mirror_hessian(const scene::Scene& scene);
// Whether shadow rays start from what mirrored rays met, too.
bool mirrors_shadows(const scene::Scene& scene);

// The file of shaders/ with sky(): what is seen beside the surface.
const char* sky_file(const scene::Scene& scene);

// The parts of the shade pass after rays, shading.glsl and surface_color(): the generated shade().
void add_shading(ShaderText& text, const scene::Scene& scene);
// light_at().
// The same of what is seen in a mirror of one surface among several: seen_again().
void add_seen_shading(ShaderText& text, const scene::Scene& scene);
void add_lights(ShaderText& text, const scene::Scene& scene);

} // namespace isomotion::synthesis
