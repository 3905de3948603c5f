// The shaders of glass: rays that continue through the surface, refracted and absorbed, one after
// the other.
//
// The light of a pixel follows a path. It begins where the eye's ray met the surface (glass_first),
// is marched like any ray (glass), and continues where that ray ended (glass_next): refracted, or
// totally reflected. Partially reflected light sees the surroundings, as in mirrors.
#pragma once

#include <string>

#include "scene/scene.h"
#include "shader/pass.h"
#include "shader/shader_text.h"

namespace isomotion::shader {

inline bool has_glass(const scene::OneSurface& one) {
    return one.surface.material.glass.has_value();
}
// float beside_reflection(float): the weight of the surface's own colour. Light that it gives back
// entered it if it is matt; the highlights of other models are of what is reflected.
std::string beside_reflection(const scene::OneSurface& one);
// float transmission(): the part of all light that meets the surface which may enter it.
std::string transmission(const scene::OneSurface& one);
// float opaque_part(): the part of what is matt that is as without glass.
std::string opaque_part();
// Adds seen_around() and see_behind(), for paths: what surrounds the surfaces.
void add_surroundings(ShaderText& text, const scene::Scene& scene);
// Whether shadows on the ground are visible through it.
bool shows_shadows_through_glass(const scene::OneSurface& one);

// Adds pixel_ray() for paths. Needs the eye's as eye_ray().
void add_glass_ray(ShaderText& text);
// For the shade pass, before and after lit(): add opaque_part() and with_glass().
void add_matter(ShaderText& text, const scene::OneSurface& one);
void add_seen_through_glass(ShaderText& text, const scene::OneSurface& one);

// A pass that looks at paths alone: `text` knows what a path is.
Pass pass_over_paths(ShaderText text, Role role, const char* name, const char* file,
                     Cover cover = {});

// The passes of glass besides its march, in the order in which a tile runs them.
std::vector<Pass> glass_passes(const scene::OneSurface& one, const PassPlan& plan);

} // namespace isomotion::shader
