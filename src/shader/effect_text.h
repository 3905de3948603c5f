// Shaders of scenes with more than one plain light: the ends of rays are kept, further rays start
// there, and the picture is shaded from all of these.
#pragma once

#include <optional>

#include "formula/field.h"
#include "scene/scene.h"
#include "shader/shader_text.h"

namespace isomotion::shader {

// A bit for each light that casts shadows.
int shadow_mask(const scene::Scene& scene);
int far_lights(const scene::Scene& scene);

// Whether mirrors show an environment map, blurred by their roughness and by a pixel's footprint.
bool mirrors_environment(const scene::OneSurface& one);
// The field's second derivatives, from which the shade pass computes how the normal changes within
// a pixel. For a scene that mirrors an environment, unless they are too long for a shader.
std::optional<formula::Program> mirror_hessian(const scene::OneSurface& one);
// Whether shadow rays also start where mirrored rays ended.
bool mirrors_shadows(const scene::OneSurface& one);

// Adds sky(), the background beside the surface, and what else is around it.
void add_sky(ShaderText& text, const scene::Scene& scene);

// Adds the parts of the shade pass after rays, shading.glsl and surface_color(): the generated
// shade().
void add_shading(ShaderText& text, const scene::OneSurface& one);
// The same for what is seen in a mirror of one surface among several: seen_again().
void add_seen_shading(ShaderText& text, const scene::OneSurface& one);
// lit_again() alone, in the middle of a path; where add_surroundings() has declared the ground.
void add_lit_again(ShaderText& text, const scene::OneSurface& one);
// Adds light_at().
void add_lights(ShaderText& text, const scene::Scene& scene);

} // namespace isomotion::shader
