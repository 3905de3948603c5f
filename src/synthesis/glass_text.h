// The shaders of glass: rays that go on through the surface, bent and absorbed, one after the
// other.
//
// A pixel's light has a path. It begins where the eye's ray met the surface (glass_first), is
// marched as any ray (glass), and goes on from where that ended (glass_next): refracted, or totally
// reflected. What is reflected in part sees what is around, as mirrors do.
#pragma once

#include "scene/scene.h"
#include "synthesis/pass.h"
#include "synthesis/shader_text.h"

namespace isomotion::synthesis {

inline bool has_glass(const scene::Scene& scene) { return scene.material.glass.has_value(); }
// Whether shadows are seen on the ground through it.
bool shows_shadows_through_glass(const scene::Scene& scene);

// pixel_ray() of paths. Needs the eye's as eye_ray().
void add_glass_ray(ShaderText& text);
// For the shade pass, before and after lit(): opaque_part(), and with_glass().
void add_matter(ShaderText& text, const scene::Scene& scene);
void add_seen_through_glass(ShaderText& text, const scene::Scene& scene);

// The passes of glass beside its march, in the order in which a tile takes them.
std::vector<Pass> glass_passes(const scene::Scene& scene, const Passes& passes);

} // namespace isomotion::synthesis
