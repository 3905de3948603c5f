#include "synthesis/effect_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "synthesis/effect.h"
#include "synthesis/shader_files.h"
#include "synthesis/surfaces_text.h"

namespace isomotion::synthesis {
namespace {

using Reflection = scene::Material::Reflection;

// vec3 name(...): the light of everything that shines on p, as it goes to the viewer.
std::string lit(const scene::Scene& scene, const char* name, bool with_shadows) {
    const bool occluded = scene.occlusion && with_shadows;
    std::string text = fmt::format("vec3 {}(SurfacePoint p, Hit hit, vec3 to_viewer) {{\n", name);
    text += scene.ground
                ? "    vec3 albedo = p.on_ground ? ground_color.rgb : surface_color(hit);\n"
                : "    vec3 albedo = surface_color(hit);\n";
    // Metal has no matt part that light from everywhere could come back from.
    const bool metal = scene.material.model == scene::Material::Model::ggx;
    text += fmt::format("    vec3 sum = {} * albedo{}{};\n",
                        scene.ambient ? "ambient(p.normal)" : "0.12",
                        metal ? " * (1.0 - gloss.y)" : "", occluded ? " * openness(p)" : "");
    text += "    for (int k = 0; k < LIGHTS; ++k) {\n"
            "        LightRay light = light_at(k, p.position);\n";
    text += scene.ground
                ? "        vec3 share = p.on_ground\n"
                  "            ? albedo * max(dot(p.normal, light.direction), 0.0)\n"
                  "            : reflected(albedo, p.normal, to_viewer, light.direction);\n"
                : "        vec3 share = reflected(albedo, p.normal, to_viewer, "
                  "light.direction);\n";
    text += fmt::format("        sum += light.strength * share{};\n",
                        shadow_mask(scene) != 0 && with_shadows ? " * visibility(k)" : "");
    return text + "    }\n    return sum;\n}\n";
}

// What is around a place in a direction.
std::string around(const scene::Scene& scene, const char* direction) {
    return scene.environment ? fmt::format("environment({})", direction)
                             : fmt::format("sky({}).rgb", direction);
}

// vec3 with_mirror(...): with what is seen in the mirror.
std::string with_mirror(const scene::Scene& scene) {
    // The matt part of other materials is what their highlight leaves; a matt one gets a clear
    // coat.
    const bool matt = scene.material.model == scene::Material::Model::lambert;
    return fmt::format("vec3 with_mirror(vec3 color, Hit hit, vec3 to_viewer, vec3 seen) "
                       "{{\n    vec3 weight = mirror_weight(surface_color(hit), "
                       "hit.normal, to_viewer);\n    return color{} + weight * seen;\n}}\n",
                       matt ? " * (1.0 - weight)" : "");
}

// vec3 mirrored(...): with what the surface mirrors; a mirror in a mirror shows what is around.
std::string mirrored(const scene::Scene& scene) {
    std::string text = with_mirror(scene);
    text += "vec3 mirrored(vec3 color, Ray ray, SurfacePoint p, Hit hit) {\n";
    if (scene.ground) text += "    if (p.on_ground) return color;\n";
    text += fmt::format("    vec3 direction = reflect(ray.direction, p.normal);\n"
                        "    vec3 seen = {};\n",
                        around(scene, "direction"));
    if (scene.material.reflection == Reflection::self && is_among(scene)) {
        text += "    vec4 other = seen_in_mirror();\n"
                "    if (other.a > 0.0) seen = other.rgb;\n";
    } else if (scene.material.reflection == Reflection::self) {
        text += fmt::format("    SurfacePoint q = load_mirrored();\n"
                            "    Hit other = hit_of(q);\n"
                            "    if (is_on_surface(q) || q.on_ground) seen = lit_again(q, other, "
                            "-direction);\n"
                            "    if (is_on_surface(q)) {{\n"
                            "        seen = with_mirror(seen, other, -direction, {});\n    }}\n",
                            around(scene, "reflect(direction, q.normal)"));
    }
    return text + "    return with_mirror(color, hit, -ray.direction, seen);\n}\n";
}

// What one surface among several has in place of an effect's file: what it does is done for all.
std::string_view file_among(Effect effect) {
    switch (effect) {
    case Effect::occlusion:
        return "surfaces/openness.glsl";
    case Effect::self_reflection:
        return "surfaces/seen.glsl";
    default:
        return {};
    }
}

void add_effects(ShaderText& text, const scene::Scene& scene, bool in_mirror) {
    if (scene.material.model == scene::Material::Model::lambert)
        text.file("effects/brdf_lambert.glsl");
    for (const Effect effect : effects(scene)) {
        const EffectTraits& row = traits(effect);
        const std::string_view among = is_among(scene) ? file_among(effect) : std::string_view{};
        if (in_mirror && (effect == Effect::shadows || !among.empty())) continue;
        if (!row.kernel.empty()) {
            for (const auto& file : kernel_files({std::string(row.kernel)})) text.file(file);
        }
        if (!among.empty()) {
            text.file(std::string(among));
        } else if (!row.file.empty()) {
            text.file(fmt::format("effects/{}.glsl", row.file));
        }
    }
    text.file(scene.environment && scene.environment->background ? "effects/sky_environment.glsl"
              : scene.output.gradient                            ? "effects/sky_gradient.glsl"
                                                                 : "effects/sky_flat.glsl");
}

} // namespace

int shadow_mask(const scene::Scene& scene) {
    int mask = 0;
    for (std::size_t k = 0; k < scene.lights.size(); ++k) mask |= int(scene.lights[k].shadow) << k;
    return mask;
}

int far_lights(const scene::Scene& scene) {
    int mask = 0;
    for (std::size_t k = 0; k < scene.lights.size(); ++k)
        mask |= int(!scene.lights[k].is_point) << k;
    return mask;
}

void add_lights(ShaderText& text, const scene::Scene& scene) {
    const bool near = far_lights(scene) != (1 << scene.lights.size()) - 1;
    text.file("effects/light.glsl");
    text.file(near ? "effects/near_lights.glsl" : "effects/far_lights.glsl");
}

void add_shading(ShaderText& text, const scene::Scene& scene) {
    const Reflection reflection = scene.material.reflection;
    const bool has_shadows = shadow_mask(scene) != 0;
    add_lights(text, scene);
    text.file("effects/hit_of.glsl");
    if (!scene.sections.empty()) text.file("section/distance.glsl");
    add_effects(text, scene, false);

    std::string glue = scene.ground ? "uniform vec4 ground_color;\n" : "";
    glue += lit(scene, "lit", true);
    if (reflection == Reflection::self && !is_among(scene)) glue += lit(scene, "lit_again", false);
    if (reflection != Reflection::none) glue += mirrored(scene);
    glue += "vec3 shade(Ray ray, SurfacePoint p, Hit hit) {\n"
            "    vec3 color = lit(p, hit, -ray.direction);\n";
    if (reflection != Reflection::none) glue += "    color = mirrored(color, ray, p, hit);\n";
    if (scene.fog) glue += "    color = in_fog(color, p.t - ray_begin(ray));\n";
    glue += "    return color;\n}\n";
    glue += fmt::format("float further_evaluations() {{\n    return {};\n}}\n",
                        has_shadows ? "texelFetch(shadow_texture, ivec2(gl_FragCoord.xy), 0).z"
                                    : "0.0");
    text.generated("generated: what shines and what it passes through", glue);
}

void add_seen_shading(ShaderText& text, const scene::Scene& scene) {
    add_lights(text, scene);
    text.file("effects/hit_of.glsl");
    add_effects(text, scene, true);
    const bool mirrors = scene.material.reflection != Reflection::none;
    std::string glue = scene.ground ? "uniform vec4 ground_color;\n" : "";
    glue += lit(scene, "lit_again", false);
    if (mirrors) glue += with_mirror(scene);
    // A mirror in a mirror shows what is around.
    glue += "vec3 seen_again(SurfacePoint q, Hit hit, vec3 direction) {\n"
            "    vec3 color = lit_again(q, hit, -direction);\n";
    if (mirrors) {
        glue += fmt::format("    if (is_on_surface(q)) color = with_mirror(color, hit, -direction, "
                            "{});\n",
                            around(scene, "reflect(direction, q.normal)"));
    }
    text.generated("generated: what shines on what is seen in a mirror",
                   glue + "    return color;\n}\n");
}

} // namespace isomotion::synthesis
