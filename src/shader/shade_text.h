// The shaders that make the picture from the ends of rays.
#pragma once

#include "scene/scene.h"
#include "shader/march_text.h"
#include "shader/shader_text.h"

namespace isomotion::shader {

// Shading, Hit and the record of a pixel.
void add_picture(ShaderText& text, const scene::OneSurface& one, Draws draws = Draws::several);
// surface_color(): the colour of the matter, and over it whatever else colours the surface, each
// made from what is below it.
void add_color(ShaderText& text, const scene::OneSurface& one);
// surface_gradient().
void add_gradient(ShaderText& text, const PassPlan& plan);

// The channels that the shade pass writes, in the order of its attachments, whatever the order of
// the request.
std::vector<Channel> written_channels(const std::vector<Channel>& channels);

// Whether march and picture may be one draw: only the picture needs the ends of rays.
// `attachments`: channels that are written. Else there are passes.
bool can_fuse(const scene::OneSurface& one, const std::vector<Channel>& channels, int attachments);
Pass fused_pass(const scene::OneSurface& one, const PassPlan& plan);
// The same where the beams by models have settled a block.
Pass settled_pass(const scene::OneSurface& one, const PassPlan& plan);
Pass mask_pass(const scene::OneSurface& one, const PassPlan& plan);

// The beginning of a pass that shades what further rays see of one surface among several: what its
// colours ask of the field, the ray, the picture, colours, and SurfacePoint.
ShaderText begin_seen(const scene::OneSurface& one, const PassPlan& plan);

// Keeps where rays ended: Role::surface, mirror_surface or glass_end, by their origin.
Pass surface_pass(const scene::OneSurface& one, const PassPlan& plan, Origin origin, When when);
// What mirrored rays see of this surface among several.
Pass seen_pass(const scene::OneSurface& one, const PassPlan& plan);
Pass shade_pass(const scene::OneSurface& one, const PassPlan& plan, When when);
// The channel velocity.
Pass motion_pass(const scene::OneSurface& one, const PassPlan& plan);

} // namespace isomotion::shader
