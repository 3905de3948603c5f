// The shaders of glass among several surfaces: the path of a pixel's light goes on from surface to
// surface, refracted, mirrored and absorbed. Each surface has its own passes, which share data in
// textures: shaders/paths/.
//
// A path begins where the eye's ray met glass or a mirror of all surfaces (glass_first). Its ray is
// marched on each surface (glass), of whose ends the nearest is kept (glass_end). Each surface of
// glass tells whether its matter is behind that (glass_beyond); the surface that was met continues
// the path (glass_next).
#pragma once

#include <algorithm>

#include "scene/scene.h"
#include "shader/pass.h"
#include "shader/shader_text.h"

namespace isomotion::shader {

// How often a path's ray goes on where matter begins or ends at the bounds of a surface.
inline constexpr int most_crossings = 32;

// Whether any surface among several is of glass. Then mirrored rays are rays of paths, too.
inline bool follows_paths(const scene::Scene& scene) {
    return scene.surfaces.size() > 1 && std::ranges::any_of(scene.surfaces, [](const auto& each) {
               return each.material.glass.has_value();
           });
}

// What the passes of rays through glass are drawn over. Among several surfaces late rays are few.
inline Cover cover_of_paths(const scene::Scene& scene) {
    return {follows_paths(scene) ? Cover::Area::rectangles : Cover::Area::whole};
}

// Adds pixel_ray() for paths. Needs the eye's as eye_ray().
void add_path_ray(ShaderText& text, const scene::OneSurface& one);
// Adds store_begin() to the pass that keeps where the eye's rays ended; needs store_nearest().
void add_begin_of_path(ShaderText& text, const scene::OneSurface& one);
// Adds or_at_bounds() to the pass that keeps where rays of paths ended.
void add_end_at_bounds(ShaderText& text);
// For the shade pass, before and after lit(): add opaque_part() and with_path().
void add_matter_of_surface(ShaderText& text, const scene::OneSurface& one);
void add_seen_by_path(ShaderText& text, const scene::OneSurface& one);

// The passes of one surface's paths besides their march.
std::vector<Pass> path_passes(const scene::OneSurface& one, const PassPlan& plan);

} // namespace isomotion::shader
