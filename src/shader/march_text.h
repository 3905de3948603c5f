// The shaders that march rays: the eye's, mirrored ones, those through glass, and shadow rays.
#pragma once

#include "scene/scene.h"
#include "shader/shader_text.h"

namespace isomotion::shader {

enum class Origin { eye, mirror, glass };

// The functions of the field that a step of the method's march evaluates.
std::vector<FieldFunction> samples_of(const scene::OneSurface& one, bool march_takes_gradient);

// Defines Ray, pixel_ray() and RayState: the origin of rays and the state kept for them.
void add_ray(ShaderText& text, const scene::OneSurface& one, Origin origin = Origin::eye);
// Defines the shape of the bounds.
void define_bounds(ShaderText& text, const scene::OneSurface& one);
// Defines the additional parts of a ray's state. Call it before add_ray().
void define_state(ShaderText& text, const PassPlan& plan);
// Whether march and picture are one draw, or several.
enum class Draws { one, several };
// Defines begin() and march(), after the field and the ray.
void add_march(ShaderText& text, const scene::OneSurface& one, const PassPlan& plan, Origin origin,
               Draws draws = Draws::several);

// Defines march() for rays whose first root is known to lie in a piece, and begin_in_slab(), which
// tells that piece. After the field and the ray.
void add_settled_march(ShaderText& text, const PassPlan& plan);

// One pass of rays. `when`: for the eye's rays, whether they are tried in one draw first.
Pass march_pass(const scene::OneSurface& one, const PassPlan& plan, Origin origin, When when);
// Counts rays that still march.
Pass active_pass(When when);
// One pass of shadow rays.
Pass shadow_pass(const scene::OneSurface& one, const PassPlan& plan);

} // namespace isomotion::shader
