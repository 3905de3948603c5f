// Additions to the shaders of one surface among several: the nearest end on all of them counts, and
// rays that begin on one see all. Each surface has its own passes, which share data in textures.
#pragma once

#include <vector>

#include "scene/scene.h"
#include "shader/march_text.h"
#include "shader/shader_text.h"

namespace isomotion::shader {

// Whether rays are mirrored, by this surface or by another.
bool has_mirrored_rays(const scene::OneSurface& one);

// Adds load_surface(), for any surface, in this one's formula coordinates.
void add_load_surface(ShaderText& text, const scene::OneSurface& one);
// Adds pixel_ray() of mirrored rays. Needs load_surface().
void add_mirror_ray(ShaderText& text, const scene::OneSurface& one);
// Adds the ways along the ray that surfaces share, for rays that march only as far as the surfaces
// before. Call it before enter_beam() is added.
void add_ways(ShaderText& text, const scene::OneSurface& one, Origin origin);
// The attachment of pictures drawn so that has the way to what is seen, after those of channels.
inline int way_attachment(const PassPlan& plan) { return 2 + int(plan.attachments.size()); }
// All surfaces are drawn in one draw each, or none.
void agree_on_draws(std::vector<Passes*> all);
// store_nearest().
void add_store_nearest(ShaderText& text, const scene::OneSurface& one, Origin origin);
// Where mirrored rays of several surfaces begin.
Pass mirror_mask_pass(const scene::Scene& scene);
Pass occlusion_pass(const scene::OneSurface& one, const PassPlan& plan);

} // namespace isomotion::shader
