// Sections of a scene (scene/cut.h) in shaders: shaders/section/. A scene without any adds nothing.
#pragma once

#include "scene/scene.h"
#include "scene/scene_at.h"
#include "synthesis/shader_text.h"
#include "synthesis/uniform.h"

namespace isomotion::synthesis {

// The parts that sections can leave of a ray at most.
int parts_of_a_ray(const scene::Scene& scene);
// What a ray samples beside its march, at most: F where parts end and begin.
int samples_at_sections(const scene::Scene& scene);

// The number and kinds of sections, and where places are in them.
void add_sections(ShaderText& text, const scene::Scene& scene);
// The parts of a ray, and on which cap one ended. After the ray and its state.
void add_parts(ShaderText& text, const scene::Scene& scene);
// Least and most of sections over boxes, for beams.
void add_sections_over_boxes(ShaderText& text, const scene::Scene& scene);
// How rays come from one part to the next. After what samples F.
void add_crossings(ShaderText& text, const scene::Scene& scene);
// About the text of a method's turn, whose first sample tells whether a part begins with a cap.
void begin_turn_of_part(ShaderText& text);
void end_turn_of_part(ShaderText& text);
// The file of a march, which knows one part of a ray, as march through all of them. `samples_tell`:
// what it samples tells of caps; else the ends of parts are sampled beside.
void add_march_through_parts(ShaderText& text, const scene::Scene& scene, const std::string& file,
                             bool samples_tell);
// The file with the gradient of F, as that of what is left of the solid.
void add_gradient_of_rest(ShaderText& text, const scene::Scene& scene, const std::string& file);

// Whether caps have another colour than the matter has everywhere.
bool has_cap_color(const scene::Scene& scene);

// Uniform `sections` at a time, in formula coordinates.
Uniform sections_uniform(const scene::SceneAt& now);

} // namespace isomotion::synthesis
