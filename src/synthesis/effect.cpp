#include "synthesis/effect.h"

#include <algorithm>
#include <array>

#include "scene/nth_surface.h"
#include "synthesis/section_text.h"

namespace isomotion::synthesis {
namespace {

using scene::Light, scene::Scene, scene::SceneAt;
using Model = scene::Material::Model;
using Reflection = scene::Material::Reflection;

bool any_light(const Scene& scene, bool Light::*has) {
    return std::any_of(scene.lights.begin(), scene.lights.end(),
                       [&](const Light& light) { return light.*has; });
}

void add(Uniforms& to, const char* name, const glm::dvec3& v, double w = 0) {
    to.push_back({name, glm::vec4(glm::dvec4(v, w))});
}
void add_vector(Uniforms& to, const char* name, const glm::dvec3& v) {
    to.push_back({name, glm::vec3(v)});
}

void add_gloss(const Scene&, const SceneAt& now, Uniforms& to) {
    to.push_back({"gloss", glm::vec4(now.surface.gloss)});
}
void become_matt(Scene& scene) { scene.surface.material.model = Model::lambert; }

const std::array table{
    EffectTraits{Effect::point_lights, "point-lights", "lights.position: lights at a place",
                 [](const Scene& s) { return any_light(s, &Light::is_point); },
                 [](Scene& s) {
                     // There are as many lights without it, but from over the viewer's shoulder.
                     for (Light& light : s.lights) {
                         light.headlight |= light.is_point;
                         light.is_point = false;
                     }
                 },
                 true},
    EffectTraits{Effect::shadows, "shadows", "lights.shadow = true: rays to the lights",
                 [](const Scene& s) { return any_light(s, &Light::shadow); },
                 [](Scene& s) {
                     for (Light& light : s.lights) light.shadow = false;
                 },
                 true, "", "shadow_mask"},
    EffectTraits{Effect::blinn_phong, "blinn-phong", "material.model: a highlight",
                 [](const Scene& s) { return s.surface.material.model == Model::blinn_phong; },
                 become_matt, true, "pow", "brdf_blinn_phong", add_gloss},
    EffectTraits{Effect::ggx, "ggx", "material.model: from plastic to metal",
                 [](const Scene& s) { return s.surface.material.model == Model::ggx; }, become_matt,
                 true, "", "brdf_ggx", add_gloss},
    EffectTraits{Effect::two_sides, "two-sides",
                 "material.back_color: a colour for the side where F < 0",
                 [](const Scene& s) { return s.surface.material.inside.has_value(); },
                 [](Scene& s) { s.surface.material.inside.reset(); }, false, "", "",
                 [](const Scene&, const SceneAt& now, Uniforms& to) {
                     add(to, "inside_color", now.surface.inside_color);
                 }},
    EffectTraits{Effect::paint, "paint", "material.colormap: colours by an expression",
                 [](const Scene& s) { return s.surface.material.paint.has_value(); },
                 [](Scene& s) { s.surface.material.paint.reset(); }, false, "", "",
                 [](const Scene& s, const SceneAt& now, Uniforms& to) {
                     to.push_back({"paint_range", glm::vec2(now.surface.paint_range)});
                     // The time is given only where it is asked for: it would tell still frames
                     // apart.
                     if (s.surface.material.paint->value->uses("t")) {
                         to.push_back({"paint_time", float(now.time)});
                     }
                 }},
    EffectTraits{Effect::color_by_place, "color-by-place",
                 "material.color: expressions of the place, or fields r, g, b of elements",
                 [](const Scene& s) {
                     return s.surface.material.color_by_place && !s.surface.material.paint;
                 },
                 [](Scene& s) { s.surface.material.color_by_place.reset(); }, false, "", "",
                 [](const Scene& s, const SceneAt& now, Uniforms& to) {
                     if (s.surface.material.color_by_place->uses("t"))
                         to.push_back({"paint_time", float(now.time)});
                 }},
    EffectTraits{Effect::mirror, "mirror", "material.reflection = \"sky\": mirrors what is around",
                 [](const Scene& s) { return s.surface.material.reflection == Reflection::sky; },
                 [](Scene& s) { s.surface.material.reflection = Reflection::none; }, true},
    EffectTraits{Effect::self_reflection, "self-reflection",
                 "material.reflection = \"self\": and the surface itself, by a second ray",
                 [](const Scene& s) { return s.surface.material.reflection == Reflection::self; },
                 [](Scene& s) { s.surface.material.reflection = Reflection::sky; }, true, "",
                 "load_mirrored"},
    EffectTraits{Effect::occlusion, "occlusion",
                 "[occlusion]: less light from around where something is near",
                 [](const Scene& s) { return s.occlusion.has_value(); },
                 [](Scene& s) { s.occlusion.reset(); }, true, "", "occlusion",
                 [](const Scene&, const SceneAt& now, Uniforms& to) {
                     add(to, "occlusion",
                         {now.occlusion.reach / now.surface.placement.scale, now.occlusion.strength,
                          0});
                 }},
    EffectTraits{Effect::ground, "ground", "[ground]: a plane",
                 [](const Scene& s) { return s.ground.has_value(); },
                 [](Scene& s) { s.ground.reset(); }, true, "", "",
                 [](const Scene&, const SceneAt& now, Uniforms& to) {
                     // In double: the ground may be far from the world's origin and near the
                     // surface.
                     const scene::PlacementAt& place = now.surface.placement;
                     add(to, "ground_plane", glm::transpose(place.rotate) * glm::dvec3(0, 0, 1),
                         (place.translate.z - now.ground.height) / place.scale);
                     add(to, "ground_color", now.ground.color);
                 }},
    EffectTraits{Effect::fog, "fog", "[fog]: fades with the distance",
                 [](const Scene& s) { return s.fog.has_value(); }, [](Scene& s) { s.fog.reset(); },
                 true, "", "fog",
                 [](const Scene&, const SceneAt& now, Uniforms& to) {
                     add(to, "fog", {now.fog.density, now.fog.start, now.surface.placement.scale});
                     add(to, "fog_color", now.fog.color);
                 }},
    EffectTraits{Effect::environment, "environment", "[environment]: a map of what is around",
                 [](const Scene& s) { return s.environment.has_value(); },
                 [](Scene& s) { s.environment.reset(); }, true, "atan", "environment",
                 [](const Scene&, const SceneAt& now, Uniforms& to) {
                     const glm::dmat3 to_local = glm::transpose(now.surface.placement.rotate);
                     add_vector(to, "environment_ahead", to_local * now.environment->ahead);
                     add_vector(to, "environment_left", to_local * now.environment->left);
                     add_vector(to, "environment_top", to_local * now.environment->top);
                     to.push_back({"environment_intensity", float(now.environment->intensity)});
                 }},
    EffectTraits{Effect::gradient, "gradient", "output.background = { top, bottom }",
                 [](const Scene& s) { return s.output.gradient.has_value(); },
                 [](Scene& s) { s.output.gradient.reset(); }, true, "", "",
                 [](const Scene& s, const SceneAt&, Uniforms& to) {
                     const auto& [top, bottom] = *s.output.gradient;
                     add_vector(to, "sky_top", {top[0], top[1], top[2]});
                     add_vector(to, "sky_bottom", {bottom[0], bottom[1], bottom[2]});
                 }},
    EffectTraits{Effect::samples, "samples",
                 "output.samples: a frame is the mean of pictures, smooth edges",
                 [](const Scene& s) { return s.output.samples > 1; },
                 [](Scene& s) { s.output.samples = 1; }},
    EffectTraits{Effect::motion_blur, "motion-blur",
                 "camera.shutter: at times while the shutter is open",
                 [](const Scene& s) { return s.camera.shutter > 0; },
                 [](Scene& s) { s.camera.shutter = 0; }},
    EffectTraits{Effect::depth_of_field, "depth-of-field",
                 "camera.aperture: from points of the lens",
                 [](const Scene& s) { return s.camera.aperture.has_value(); },
                 [](Scene& s) { s.camera.aperture.reset(); }},
    EffectTraits{Effect::light_size, "light-size",
                 "lights.radius: soft shadows, from points of the light",
                 [](const Scene& s) {
                     return std::ranges::any_of(
                         s.lights, [](const Light& light) { return light.radius.has_value(); });
                 },
                 [](Scene& s) {
                     for (Light& light : s.lights) light.radius.reset();
                 }},
    EffectTraits{Effect::ambient, "ambient", "[ambient]: light from everywhere, of two colours",
                 [](const Scene& s) { return s.ambient.has_value(); },
                 [](Scene& s) { s.ambient.reset(); }, true, "", "ambient",
                 [](const Scene&, const SceneAt& now, Uniforms& to) {
                     add(to, "ambient_top", now.ambient.top);
                     add(to, "ambient_bottom", now.ambient.bottom);
                 }},
    EffectTraits{Effect::sections, "sections", "[[sections]]: what is cut off the solid",
                 [](const Scene& s) { return !s.sections.empty(); },
                 [](Scene& s) { s.sections.clear(); }, false, "", "",
                 [](const Scene& s, const SceneAt& now, Uniforms& to) {
                     to.push_back(sections_uniform(now));
                     if (!has_cap_color(s)) return;
                     add(to, "cap_color",
                         s.surface.material.cap ? now.surface.cap_color : now.surface.inside_color);
                 }},
    EffectTraits{Effect::contours, "contours", "material.contours: lines where a number is whole",
                 [](const Scene& s) { return s.surface.material.contours.has_value(); },
                 [](Scene& s) { s.surface.material.contours.reset(); }, false, "", "",
                 [](const Scene& s, const SceneAt& now, Uniforms& to) {
                     const scene::ContoursAt& lines = now.surface.contours;
                     add(to, "contours", {lines.every, lines.from, lines.width});
                     add(to, "contour_color", lines.color);
                     if (s.surface.material.contours->value->uses("t"))
                         to.push_back({"contour_time", float(now.time)});
                 }},
    EffectTraits{
        Effect::glass, "glass", "material.transmission: light goes through, refracted and absorbed",
        [](const Scene& s) { return s.surface.material.glass.has_value(); },
        [](Scene& s) { s.surface.material.glass.reset(); }, true, "", "",
        [](const Scene& s, const SceneAt& now, Uniforms& to) {
            add(to, "glass",
                {now.surface.glass.transmission, now.surface.glass.ior,
                 s.surface.material.glass->depth});
            add(to, "absorption", now.surface.glass.absorption * now.surface.placement.scale);
        }},
};

} // namespace

std::span<const EffectTraits> effect_traits() { return table; }

const EffectTraits& traits(Effect effect) { return table[std::size_t(effect)]; }

std::vector<Effect> effects(const Scene& scene) {
    std::vector<Effect> found;
    for (const EffectTraits& row : table) {
        bool is_called = false;
        scene::for_each_surface(scene, [&](const Scene& one) { is_called |= row.is_called(one); });
        if (is_called) found.push_back(row.effect);
    }
    return found;
}

Scene without(Effect effect, Scene scene) {
    scene::for_each_surface(scene, traits(effect).drop);
    return scene;
}

bool calls_for_ends(const Scene& scene) {
    // Beside glass, every surface is seen by rays that begin where others ended.
    return !scene.among.matters.empty() ||
           std::any_of(table.begin(), table.end(), [&](const EffectTraits& row) {
               return row.keeps_surfaces && row.is_called(scene);
           });
}

bool keeps_surfaces(const Scene& scene) { return scene.among.count > 1 || calls_for_ends(scene); }

Uniforms effect_uniforms(const Scene& scene, const SceneAt& now) {
    Uniforms uniforms;
    for (const EffectTraits& row : table) {
        if (row.add_uniforms && row.is_called(scene)) row.add_uniforms(scene, now, uniforms);
    }
    return uniforms;
}

} // namespace isomotion::synthesis
