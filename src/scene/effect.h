// The effects that a scene may call for. Each is code of its own: effects that a scene does not
// name are neither compiled nor run.
#pragma once

#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace isomotion::scene {

enum class Effect {
    point_lights,
    shadows,
    blinn_phong,
    ggx,
    two_sides,
    paint,
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
};

struct EffectName {
    Effect effect;
    std::string_view name;
    std::string_view summary; // with the key that calls for it
};

inline constexpr EffectName effect_names[] = {
    {Effect::point_lights, "point-lights", "lights.position: lights at a place"},
    {Effect::shadows, "shadows", "lights.shadow = true: rays to the lights"},
    {Effect::blinn_phong, "blinn-phong", "material.model: a highlight"},
    {Effect::ggx, "ggx", "material.model: from plastic to metal"},
    {Effect::two_sides, "two-sides", "material.back_color: a colour for the side where F < 0"},
    {Effect::paint, "paint", "material.colormap: colours by an expression"},
    {Effect::mirror, "mirror", "material.reflection = \"sky\": mirrors what is around"},
    {Effect::self_reflection, "self-reflection",
     "material.reflection = \"self\": and the surface itself, by a second ray"},
    {Effect::occlusion, "occlusion", "[occlusion]: less light from around where something is near"},
    {Effect::ground, "ground", "[ground]: a plane"},
    {Effect::fog, "fog", "[fog]: fades with the distance"},
    {Effect::environment, "environment", "[environment]: a map of what is around"},
    {Effect::gradient, "gradient", "output.background = { top, bottom }"},
    {Effect::samples, "samples", "output.samples: a frame is the mean of pictures, smooth edges"},
    {Effect::motion_blur, "motion-blur", "camera.shutter: at times while the shutter is open"},
    {Effect::depth_of_field, "depth-of-field", "camera.aperture: from points of the lens"},
};

std::string_view name(Effect effect);

// The effects that a scene calls for, in the order above.
std::vector<Effect> effects(const Scene& scene);

// The scene as if it did not call for the effect.
Scene without(Effect effect, Scene scene);

} // namespace isomotion::scene
