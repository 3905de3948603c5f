#include "scene/effect.h"

#include <algorithm>

namespace isomotion::scene {
namespace {

using Model = Material::Model;
using Reflection = Material::Reflection;

bool calls_for(const Scene& scene, Effect effect) {
    const auto any_light = [&](bool Light::*has) {
        return std::any_of(scene.lights.begin(), scene.lights.end(),
                           [&](const Light& light) { return light.*has; });
    };
    switch (effect) {
    case Effect::point_lights:
        return any_light(&Light::is_point);
    case Effect::shadows:
        return any_light(&Light::shadow);
    case Effect::blinn_phong:
        return scene.material.model == Model::blinn_phong;
    case Effect::ggx:
        return scene.material.model == Model::ggx;
    case Effect::two_sides:
        return scene.material.inside.has_value();
    case Effect::paint:
        return scene.material.paint.has_value();
    case Effect::mirror:
        return scene.material.reflection == Reflection::sky;
    case Effect::self_reflection:
        return scene.material.reflection == Reflection::self;
    case Effect::occlusion:
        return scene.occlusion.has_value();
    case Effect::ground:
        return scene.ground.has_value();
    case Effect::fog:
        return scene.fog.has_value();
    case Effect::environment:
        return scene.environment.has_value();
    case Effect::gradient:
        return scene.output.gradient.has_value();
    case Effect::samples:
        return scene.output.samples > 1;
    case Effect::motion_blur:
        return scene.camera.shutter > 0;
    case Effect::depth_of_field:
        return scene.camera.aperture.has_value();
    }
    return false;
}

} // namespace

std::string_view name(Effect effect) {
    for (const EffectName& entry : effect_names) {
        if (entry.effect == effect) return entry.name;
    }
    return "?";
}

std::vector<Effect> effects(const Scene& scene) {
    std::vector<Effect> found;
    for (const EffectName& entry : effect_names) {
        if (calls_for(scene, entry.effect)) found.push_back(entry.effect);
    }
    return found;
}

Scene without(Effect effect, Scene scene) {
    switch (effect) {
    case Effect::point_lights:
        // Keeps the number of lights; they shine from over the viewer's shoulder.
        for (Light& light : scene.lights) {
            light.headlight |= light.is_point;
            light.is_point = false;
        }
        break;
    case Effect::shadows:
        for (Light& light : scene.lights) light.shadow = false;
        break;
    case Effect::blinn_phong:
    case Effect::ggx:
        scene.material.model = Model::lambert;
        break;
    case Effect::two_sides:
        scene.material.inside.reset();
        break;
    case Effect::paint:
        scene.material.paint.reset();
        break;
    case Effect::mirror:
        scene.material.reflection = Reflection::none;
        break;
    case Effect::self_reflection:
        scene.material.reflection = Reflection::sky;
        break;
    case Effect::occlusion:
        scene.occlusion.reset();
        break;
    case Effect::ground:
        scene.ground.reset();
        break;
    case Effect::fog:
        scene.fog.reset();
        break;
    case Effect::environment:
        scene.environment.reset();
        break;
    case Effect::gradient:
        scene.output.gradient.reset();
        break;
    case Effect::samples:
        scene.output.samples = 1;
        break;
    case Effect::motion_blur:
        scene.camera.shutter = 0;
        break;
    case Effect::depth_of_field:
        scene.camera.aperture.reset();
        break;
    }
    return scene;
}

} // namespace isomotion::scene
