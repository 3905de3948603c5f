// The effects of scenes, one row each. An effect consists of its row, its keys of a scene file
// (scene/reading) and its files of shaders/effects/. Effects that a scene does not name are neither
// compiled nor run.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "scene/scene_at.h"
#include "shader/uniform.h"

namespace isomotion::shader {

enum class Effect {
    point_lights,
    shadows,
    blinn_phong,
    ggx,
    two_sides,
    paint,
    color_by_place,
    mirror,
    self_reflection,
    occlusion,
    ground,
    fog,
    environment,
    gradient,
    samples,
    motion_blur,
    depth_of_field,
    light_size,
    ambient,
    sections,
    contours,
    glass,
};

struct EffectTraits {
    Effect effect;
    std::string_view name;
    std::string_view summary; // with the key that enables it
    bool (*is_called)(const scene::OneSurface&);
    // Changes a scene so that it does not use the effect.
    void (*drop)(scene::Scene&);
    // Whether the ends of rays must be kept, since further rays or light start there.
    bool keeps_surfaces = false;
    // A kernel of shaders/math/ that its part of the shade pass calls, and the file of
    // shaders/effects/ with that part; either may be empty.
    std::string_view kernel = {}, file = {};
    // Adds its values at a time, under the names that its files declare; or null.
    void (*add_uniforms)(const scene::OneSurface&, const scene::OneSurfaceAt&, Uniforms&) = nullptr;
};

// All of them, in the order of the enumeration.
std::span<const EffectTraits> effect_traits();
const EffectTraits& traits(Effect effect);
inline std::string_view name(Effect effect) { return traits(effect).name; }

// The effects that a scene uses, or one of its surfaces, in that order.
std::vector<Effect> effects(const scene::Scene& scene);
std::vector<Effect> effects(const scene::OneSurface& one);
// The scene without the effect.
scene::Scene without(Effect effect, scene::Scene scene);
// Whether an effect that the scene calls for needs the ends of rays.
bool calls_for_ends(const scene::OneSurface& one);
// Whether passes may need the ends of rays: several surfaces need them, too.
bool keeps_surfaces(const scene::OneSurface& one);
// The plain uniforms of the surface's effects.
Uniforms effect_uniforms(const scene::OneSurface& one, const scene::OneSurfaceAt& now);

} // namespace isomotion::shader
