// Sections of a scene (scene/cut.h) in shaders: shaders/section/. Without sections nothing is
// added.
#pragma once

#include "scene/scene.h"
#include "scene/scene_at.h"
#include "shader/shader_text.h"
#include "shader/uniform.h"

namespace isomotion::shader {

// The largest number of parts that sections can leave of a ray.
int parts_of_a_ray(const scene::Scene& scene);
// The largest number of samples of F that a ray takes besides its march, at the ends of parts.
int samples_at_sections(const scene::Scene& scene);

// Adds the number and kinds of sections, and tests of places against them.
void add_sections(ShaderText& text, const scene::Scene& scene);
// Adds the parts of a ray, and the cap on which one ended. Call it after the ray and its state.
void add_parts(ShaderText& text, const scene::Scene& scene);
// Adds the transition of rays from one part to the next. Call it after the functions that sample F.
void add_crossings(ShaderText& text, const scene::OneSurface& one);
// Adds the march of a ray through all parts that sections leave of it. `samples_tell`: its own
// samples detect caps; otherwise the ends of parts are sampled in addition.
void add_march_of_parts(ShaderText& text, const scene::OneSurface& one, bool samples_tell);

// Whether caps have a colour of their own.
bool has_cap_color(const scene::OneSurface& one);

// Uniform `sections` at a time, in formula coordinates.
Uniform sections_uniform(const scene::OneSurfaceAt& now);

} // namespace isomotion::shader
