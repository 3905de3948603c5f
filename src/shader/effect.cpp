#include "shader/effect.h"

#include <algorithm>
#include <array>

#include "shader/paths_text.h"
#include "shader/section_text.h"

namespace isomotion::shader {
namespace {

using scene::Light, scene::OneSurface, scene::OneSurfaceAt, scene::Scene, scene::Surface;
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

void add_gloss(const OneSurface&, const OneSurfaceAt& now, Uniforms& to) {
    to.push_back({"gloss", glm::vec4(now.surface.gloss)});
}
template<Model model> void become_matt(Scene& scene) {
    for (Surface& each : scene.surfaces) {
        if (each.material.model == model) each.material.model = Model::lambert;
    }
}
template<Reflection from, Reflection to> void reflect(Scene& scene) {
    for (Surface& each : scene.surfaces) {
        if (each.material.reflection == from) each.material.reflection = to;
    }
}

const std::array table{
    EffectTraits{Effect::point_lights, "point-lights", "lights.position: lights at a place",
                 [](const OneSurface& s) { return any_light(s.scene, &Light::is_point); },
                 [](Scene& s) {
                     // There are as many lights without it, but from over the viewer's shoulder.
                     for (Light& light : s.lights) {
                         light.headlight |= light.is_point;
                         light.is_point = false;
                     }
                 },
                 true},
    EffectTraits{Effect::shadows, "shadows", "lights.shadow = true: rays to the lights",
                 [](const OneSurface& s) { return any_light(s.scene, &Light::shadow); },
                 [](Scene& s) {
                     for (Light& light : s.lights) light.shadow = false;
                 },
                 true, "", "shadow_mask"},
    EffectTraits{Effect::blinn_phong, "blinn-phong", "material.model: a highlight",
                 [](const OneSurface& s) { return s.surface.material.model == Model::blinn_phong; },
                 become_matt<Model::blinn_phong>, true, "pow", "material", add_gloss},
    EffectTraits{Effect::ggx, "ggx", "material.model: from plastic to metal",
                 [](const OneSurface& s) { return s.surface.material.model == Model::ggx; },
                 become_matt<Model::ggx>, true, "", "material", add_gloss},
    EffectTraits{Effect::two_sides, "two-sides",
                 "material.back_color: a colour for the side where F < 0",
                 [](const OneSurface& s) { return s.surface.material.inside.has_value(); },
                 [](Scene& s) {
                     for (Surface& each : s.surfaces) each.material.inside.reset();
                 },
                 false, "", "",
                 [](const OneSurface&, const OneSurfaceAt& now, Uniforms& to) {
                     add(to, "inside_color", now.surface.inside_color);
                 }},
    EffectTraits{Effect::paint, "paint", "material.colormap: colours by an expression",
                 [](const OneSurface& s) { return s.surface.material.paint.has_value(); },
                 [](Scene& s) {
                     for (Surface& each : s.surfaces) each.material.paint.reset();
                 },
                 false, "", "",
                 [](const OneSurface& s, const OneSurfaceAt& now, Uniforms& to) {
                     to.push_back({"paint_range", glm::vec2(now.surface.paint_range)});
                     // The time is given only where it is asked for: it would tell still frames
                     // apart.
                     if (s.surface.material.paint->value->uses("t")) {
                         to.push_back({"paint_time", float(now.scene.time)});
                     }
                 }},
    EffectTraits{Effect::color_by_place, "color-by-place",
                 "material.color: expressions of the place, or fields r, g, b of elements",
                 [](const OneSurface& s) {
                     return s.surface.material.color_by_place && !s.surface.material.paint;
                 },
                 [](Scene& s) {
                     for (Surface& each : s.surfaces) each.material.color_by_place.reset();
                 },
                 false, "", "",
                 [](const OneSurface& s, const OneSurfaceAt& now, Uniforms& to) {
                     if (s.surface.material.color_by_place->uses("t"))
                         to.push_back({"paint_time", float(now.scene.time)});
                 }},
    EffectTraits{
        Effect::mirror, "mirror", "material.reflection = \"sky\": mirrors what is around",
        [](const OneSurface& s) { return s.surface.material.reflection == Reflection::sky; },
        reflect<Reflection::sky, Reflection::none>, true},
    EffectTraits{
        Effect::self_reflection, "self-reflection",
        "material.reflection = \"self\": and the surface itself, by a second ray",
        [](const OneSurface& s) { return s.surface.material.reflection == Reflection::self; },
        reflect<Reflection::self, Reflection::sky>, true, "", "load_mirrored"},
    EffectTraits{Effect::occlusion, "occlusion",
                 "[occlusion]: less light from around where something is near",
                 [](const OneSurface& s) { return s.scene.occlusion.has_value(); },
                 [](Scene& s) { s.occlusion.reset(); }, true, "", "occlusion",
                 [](const OneSurface&, const OneSurfaceAt& now, Uniforms& to) {
                     add(to, "occlusion",
                         {now.scene.occlusion.reach / now.surface.placement.scale,
                          now.scene.occlusion.strength, 0});
                 }},
    EffectTraits{Effect::ground, "ground", "[ground]: a plane",
                 [](const OneSurface& s) { return s.scene.ground.has_value(); },
                 [](Scene& s) { s.ground.reset(); }, true, "", "",
                 [](const OneSurface&, const OneSurfaceAt& now, Uniforms& to) {
                     // In double: the ground may be far from the world's origin and near the
                     // surface.
                     const scene::PlacementAt& place = now.surface.placement;
                     add(to, "ground_plane", glm::transpose(place.rotate) * glm::dvec3(0, 0, 1),
                         (place.translate.z - now.scene.ground.height) / place.scale);
                     add(to, "ground_color", now.scene.ground.color);
                 }},
    EffectTraits{Effect::fog, "fog", "[fog]: fades with the distance",
                 [](const OneSurface& s) { return s.scene.fog.has_value(); },
                 [](Scene& s) { s.fog.reset(); }, true, "", "",
                 [](const OneSurface&, const OneSurfaceAt& now, Uniforms& to) {
                     add(to, "fog",
                         {now.scene.fog.density, now.scene.fog.start, now.surface.placement.scale});
                     add(to, "fog_color", now.scene.fog.color);
                 }},
    EffectTraits{
        Effect::environment, "environment", "[environment]: a map of what is around",
        [](const OneSurface& s) { return s.scene.environment.has_value(); },
        [](Scene& s) { s.environment.reset(); }, true, "atan", "environment",
        [](const OneSurface&, const OneSurfaceAt& now, Uniforms& to) {
            const glm::dmat3 to_local = glm::transpose(now.surface.placement.rotate);
            add_vector(to, "environment_ahead", to_local * now.scene.environment->ahead);
            add_vector(to, "environment_left", to_local * now.scene.environment->left);
            add_vector(to, "environment_top", to_local * now.scene.environment->top);
            to.push_back({"environment_intensity", float(now.scene.environment->intensity)});
        }},
    EffectTraits{Effect::gradient, "gradient", "output.background = { top, bottom }",
                 [](const OneSurface& s) { return s.scene.output.gradient.has_value(); },
                 [](Scene& s) { s.output.gradient.reset(); }, true, "", "",
                 [](const OneSurface& s, const OneSurfaceAt&, Uniforms& to) {
                     const auto& [top, bottom] = *s.scene.output.gradient;
                     add_vector(to, "sky_top", {top[0], top[1], top[2]});
                     add_vector(to, "sky_bottom", {bottom[0], bottom[1], bottom[2]});
                 }},
    EffectTraits{Effect::samples, "samples",
                 "output.samples: a frame is the mean of pictures, smooth edges",
                 [](const OneSurface& s) { return s.scene.output.samples > 1; },
                 [](Scene& s) { s.output.samples = 1; }},
    EffectTraits{Effect::motion_blur, "motion-blur",
                 "camera.shutter: at times while the shutter is open",
                 [](const OneSurface& s) { return s.scene.camera.shutter > 0; },
                 [](Scene& s) { s.camera.shutter = 0; }},
    EffectTraits{Effect::depth_of_field, "depth-of-field",
                 "camera.aperture: from points of the lens",
                 [](const OneSurface& s) { return s.scene.camera.aperture.has_value(); },
                 [](Scene& s) { s.camera.aperture.reset(); }},
    EffectTraits{Effect::light_size, "light-size",
                 "lights.radius: soft shadows, from points of the light",
                 [](const OneSurface& s) {
                     return std::ranges::any_of(s.scene.lights, [](const Light& light) {
                         return light.radius.has_value();
                     });
                 },
                 [](Scene& s) {
                     for (Light& light : s.lights) light.radius.reset();
                 }},
    EffectTraits{Effect::ambient, "ambient", "[ambient]: light from everywhere, of two colours",
                 [](const OneSurface& s) { return s.scene.ambient.has_value(); },
                 [](Scene& s) { s.ambient.reset(); }, true, "", "",
                 [](const OneSurface&, const OneSurfaceAt& now, Uniforms& to) {
                     add(to, "ambient_top", now.scene.ambient.top);
                     add(to, "ambient_bottom", now.scene.ambient.bottom);
                 }},
    EffectTraits{Effect::sections, "sections", "[[sections]]: what is cut off the solid",
                 [](const OneSurface& s) { return !s.scene.sections.empty(); },
                 [](Scene& s) { s.sections.clear(); }, false, "", "",
                 [](const OneSurface& s, const OneSurfaceAt& now, Uniforms& to) {
                     to.push_back(sections_uniform(now));
                     if (!has_cap_color(s)) return;
                     add(to, "cap_color",
                         s.surface.material.cap ? now.surface.cap_color : now.surface.inside_color);
                 }},
    EffectTraits{Effect::contours, "contours", "material.contours: lines where a number is whole",
                 [](const OneSurface& s) { return s.surface.material.contours.has_value(); },
                 [](Scene& s) {
                     for (Surface& each : s.surfaces) each.material.contours.reset();
                 },
                 false, "", "",
                 [](const OneSurface& s, const OneSurfaceAt& now, Uniforms& to) {
                     const scene::ContoursAt& lines = now.surface.contours;
                     add(to, "contours", {lines.every, lines.from, lines.width});
                     add(to, "contour_color", lines.color);
                     if (s.surface.material.contours->value->uses("t"))
                         to.push_back({"contour_time", float(now.scene.time)});
                 }},
    EffectTraits{
        Effect::glass, "glass", "material.transmission: light goes through, refracted and absorbed",
        [](const OneSurface& s) { return s.surface.material.glass.has_value(); },
        [](Scene& s) {
            for (Surface& each : s.surfaces) each.material.glass.reset();
        },
        true, "", "",
        [](const OneSurface& s, const OneSurfaceAt& now, Uniforms& to) {
            add(to, "glass",
                {now.surface.glass.transmission, now.surface.glass.ior,
                 s.surface.material.glass->depth});
            add(to, "absorption", now.surface.glass.absorption * now.surface.placement.scale);
        }},
};

} // namespace

std::span<const EffectTraits> effect_traits() { return table; }

const EffectTraits& traits(Effect effect) { return table[std::size_t(effect)]; }

std::vector<Effect> effects(const OneSurface& one) {
    std::vector<Effect> found;
    for (const EffectTraits& row : table) {
        if (row.is_called(one)) found.push_back(row.effect);
    }
    return found;
}

std::vector<Effect> effects(const Scene& scene) {
    std::vector<Effect> found;
    for (const EffectTraits& row : table) {
        bool is_called = false;
        for (std::size_t k = 0; k < scene.surfaces.size(); ++k)
            is_called |= row.is_called(OneSurface(scene, k));
        if (is_called) found.push_back(row.effect);
    }
    return found;
}

Scene without(Effect effect, Scene scene) {
    traits(effect).drop(scene);
    return scene;
}

bool calls_for_ends(const OneSurface& one) {
    // Beside glass, every surface is seen by rays that begin where others ended.
    return follows_paths(one.scene) ||
           std::any_of(table.begin(), table.end(), [&](const EffectTraits& row) {
               return row.keeps_surfaces && row.is_called(one);
           });
}

bool keeps_surfaces(const OneSurface& one) { return !one.is_alone() || calls_for_ends(one); }

Uniforms effect_uniforms(const OneSurface& one, const OneSurfaceAt& now) {
    Uniforms uniforms;
    for (const EffectTraits& row : table) {
        if (row.add_uniforms && row.is_called(one)) row.add_uniforms(one, now, uniforms);
    }
    return uniforms;
}

} // namespace isomotion::shader
