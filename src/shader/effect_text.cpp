#include "shader/effect_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "formula/hessian.h"
#include "shader/effect.h"
#include "shader/glass_text.h"
#include "shader/paths_text.h"
#include "shader/shader_files.h"
#include "shader/surfaces_text.h"

namespace isomotion::shader {
namespace {

using Reflection = scene::Material::Reflection;

// vec3 name(...): the light of everything that shines on p, as it goes to the viewer. `visibility`
// tells of a light whether its shadow rays arrived; null: no shadows.
std::string lit(const scene::OneSurface& one, const char* name, const char* visibility,
                bool is_occluded) {
    const bool occluded = one.scene.occlusion && is_occluded;
    const bool glass = has_glass(one);
    // Metal has no matt part that light from everywhere could come back from, nor light go through.
    const bool metal = one.surface.material.model == scene::Material::Model::ggx;
    std::string text = fmt::format("vec3 {}(SurfacePoint p, Hit hit, vec3 to_viewer) {{\n", name);
    const std::string_view matt =
        glass && !metal ? "surface_color(hit) * opaque_part()" : "surface_color(hit)";
    text += one.scene.ground
                ? fmt::format("    vec3 albedo = p.on_ground ? ground_color.rgb : {};\n", matt)
                : fmt::format("    vec3 albedo = {};\n", matt);
    std::string part = metal ? "(1.0 - gloss.y)" : "";
    if (metal && glass) part = "opaque_part() * " + part;
    if (metal && one.scene.ground) part = fmt::format("(p.on_ground ? 1.0 : {})", part);
    text += fmt::format("    vec3 sum = {} * albedo{}{}{};\n",
                        one.scene.ambient ? "ambient(p.normal)" : "0.12", metal ? " * " : "", part,
                        occluded ? " * openness(p)" : "");
    const std::string lit_surface =
        fmt::format("{}(albedo, p.normal, to_viewer, light.direction)",
                    metal && glass ? "reflected_by_glass" : "reflected");
    text += "    for (int k = 0; k < LIGHTS; ++k) {\n"
            "        LightRay light = light_at(k, p.position);\n";
    text += one.scene.ground
                ? fmt::format("        vec3 share = p.on_ground\n"
                              "            ? albedo * max(dot(p.normal, light.direction), 0.0)\n"
                              "            : {};\n",
                              lit_surface)
                : fmt::format("        vec3 share = {};\n", lit_surface);
    text += fmt::format("        sum += light.strength * share{};\n",
                        visibility ? fmt::format(" * {}(k)", visibility) : "");
    return text + "    }\n    return sum;\n}\n";
}

// What a mirror shows of what is around, in a direction.
std::string around(const scene::OneSurface& one, const char* direction) {
    if (mirrors_environment(one))
        return fmt::format("rough_environment({}, mirror_alpha2())", direction);
    return one.scene.environment ? fmt::format("environment({})", direction)
                                 : fmt::format("sky({}).rgb", direction);
}

// vec3 with_mirror(...): with what is seen in the mirror.
std::string with_mirror(const scene::OneSurface& one) {
    // The matt part of other materials is what their highlight leaves; a matt one gets a clear
    // coat.
    const bool matt = one.surface.material.model == scene::Material::Model::lambert;
    return fmt::format("vec3 with_mirror(vec3 color, Hit hit, vec3 to_viewer, vec3 seen) "
                       "{{\n    vec3 weight = mirror_weight(surface_color(hit), "
                       "hit.normal, to_viewer);\n    return color{} + weight * seen;\n}}\n",
                       matt ? " * (1.0 - weight)" : "");
}

// vec3 mirrored(...): with what the surface mirrors; a mirror in a mirror shows what is around.
std::string mirrored(const scene::OneSurface& one) {
    if (follows_paths(one.scene) && one.surface.material.reflection == Reflection::self) {
        // The path's light is added to that of the surface.
        return fmt::format("vec3 mirrored(vec3 color, Ray ray, SurfacePoint p, Hit hit) {{\n{}"
                           "    return color * beside_mirror(mirror_weight(surface_color(hit), "
                           "hit.normal, -ray.direction));\n}}\n",
                           one.scene.ground ? "    if (p.on_ground) return color;\n" : "");
    }
    std::string text = with_mirror(one);
    const bool is_ggx = one.surface.material.model == scene::Material::Model::ggx;
    const bool is_blurred = mirrors_environment(one);
    if (is_blurred) {
        text += fmt::format("float mirror_alpha2() {{\n    return {};\n}}\n",
                            is_ggx ? "alpha() * alpha()" : "footprint_alpha2");
    }
    text += "vec3 mirrored(vec3 color, Ray ray, SurfacePoint p, Hit hit) {\n";
    if (one.scene.ground) text += "    if (p.on_ground) return color;\n";
    text += fmt::format("    vec3 direction = reflect(ray.direction, p.normal);\n"
                        "    vec3 seen = {};\n",
                        around(one, "direction"));
    if (one.surface.material.reflection != Reflection::self)
        return text + "    return with_mirror(color, hit, -ray.direction, seen);\n}\n";
    if (!one.is_alone()) {
        return text + "    vec4 other = seen_in_mirror();\n"
                      "    if (other.a > 0.0) seen = other.rgb;\n"
                      "    return with_mirror(color, hit, -ray.direction, seen);\n}\n";
    }
    text += "    SurfacePoint q = load_mirrored();\n"
            "    Hit other = hit_of(q);\n";
    // What is seen in a rough mirror is as rough, and so much wider is the beam that sees it.
    if (is_blurred) {
        text +=
            "    float own_alpha2 = footprint_alpha2, blur = mirror_alpha2();\n"
            "    float turn = turn_of_normal(q, direction, p.pixel + q.t * sqrt(192.0 * blur));\n"
            "    footprint_alpha2 = blur + turn * turn / 48.0;\n";
    }
    text += fmt::format("    if (is_on_surface(q) || q.on_ground) seen = lit_again(q, other, "
                        "-direction);\n"
                        "    if (is_on_surface(q)) {{\n"
                        "        seen = with_mirror(seen, other, -direction, {});\n    }}\n",
                        around(one, "reflect(direction, q.normal)"));
    if (is_blurred) text += "    footprint_alpha2 = own_alpha2;\n";
    return text + "    return with_mirror(color, hit, -ray.direction, seen);\n}\n";
}

// What one surface among several has in place of an effect's file: what it does is done for all.
std::string_view file_among(Effect effect) {
    switch (effect) {
    case Effect::occlusion:
        return "effects/occlusion.glsl";
    case Effect::self_reflection: // also of paths
        return "surfaces/seen.glsl";
    default:
        return {};
    }
}

void add_effects(ShaderText& text, const scene::OneSurface& one, bool in_mirror) {
    using Model = scene::Material::Model;
    const Model model = one.surface.material.model;
    if (model == Model::ggx) text.define(Feature::ggx);
    if (model == Model::blinn_phong) text.define(Feature::blinn_phong);
    if (model == Model::lambert) text.file("effects/material.glsl");
    for (const Effect effect : effects(one)) {
        const EffectTraits& row = traits(effect);
        const std::string_view among = !one.is_alone() ? file_among(effect) : std::string_view{};
        const bool is_skipped =
            effect == Effect::shadows ? !follows_paths(one.scene) : !among.empty();
        if (in_mirror && is_skipped) continue;
        if (!row.kernel.empty()) {
            for (const auto& file : kernel_files({std::string(row.kernel)})) text.file(file);
        }
        if (!among.empty()) {
            text.file(std::string(among));
        } else if (!row.file.empty()) {
            text.file(fmt::format("effects/{}.glsl", row.file));
        }
    }
    add_sky(text, one.scene);
}

// further_record(): what further rays took, as shaders/shade/hit.glsl packs it.
std::string further_record(const scene::OneSurface& one) {
    const auto texel = [](const char* texture) {
        return fmt::format("IM_TEXEL({}, ivec2(pixel_centre))", texture);
    };
    std::vector<std::string> shadows; // evaluations and rays undecided, as vec2
    if (shadow_mask(one.scene) != 0) shadows.push_back(texel("shadow_texture") + ".zw");
    if (mirrors_shadows(one)) shadows.push_back(texel("mirrored_shadow_texture") + ".zw");
    if (one.is_alone() && shows_shadows_through_glass(one))
        shadows.push_back(texel("glass_shadow_texture") + ".zw");
    if (follows_paths(one.scene)) shadows.emplace_back("unpacked_shadows(seen_in_mirror().a)");
    std::string text;
    const bool mirrors = one.surface.material.reflection == Reflection::self;
    if (mirrors && !one.is_alone() && !follows_paths(one.scene))
        text += "uniform sampler2D mirrored_texture_1;\nuniform sampler2D mirrored_texture_3;\n";
    text += "uvec3 further_record(SurfacePoint p) {\n    vec2 shadows = vec2(0.0);\n";
    for (const std::string& each : shadows) text += fmt::format("    shadows += {};\n", each);
    text += "    int path = 0, lost = 0;\n";
    if (follows_paths(one.scene) || (has_glass(one) && one.is_alone())) {
        text += "    path += load_path().evaluations;\n"
                "    lost += int(load_path().state == PATH_LOST);\n";
    } else if (mirrors) {
        text += fmt::format("    if (is_on_surface(p)) {{\n        path += {};\n"
                            "        int verdict = int({}.w) & 7;\n"
                            "        lost += int(verdict == VERDICT_STEP_LIMIT || "
                            "verdict == VERDICT_NAN);\n    }}\n",
                            !one.is_alone()
                                ? fmt::format("int({}.y)", texel("mirrored_texture_3"))
                                : fmt::format("int({}.w) >> 5", texel("mirrored_texture_1")),
                            texel("mirrored_texture_1"));
    }
    // Samples of effects/occlusion.glsl; of other surfaces, surfaces/occlusion.frag takes one more,
    // and slopes.
    constexpr int of_own = 5, of_another = 11;
    const int others = !one.is_alone() ? int(one.scene.surfaces.size()) - 1 : 0;
    text += fmt::format("    int open = is_on_surface(p) ? {} : 0;\n",
                        one.scene.occlusion ? of_own + others * of_another : 0);
    return text +
           "    return uvec3(uvec2(shadows.x, path), packed_further(shadows.y, lost, open));\n}\n";
}

} // namespace

void add_sky(ShaderText& text, const scene::Scene& scene) {
    if (scene.environment && scene.environment->background)
        text.define(Feature::sky_environment);
    else if (scene.output.gradient)
        text.define(Feature::sky_gradient);
    if (scene.ambient) text.define(Feature::ambient);
    if (scene.fog) text.define(Feature::fog);
    text.file("effects/sky.glsl");
}

int shadow_mask(const scene::Scene& scene) {
    int mask = 0;
    for (std::size_t k = 0; k < scene.lights.size(); ++k) mask |= int(scene.lights[k].shadow) << k;
    return mask;
}

bool mirrors_environment(const scene::OneSurface& one) {
    // Where several surfaces mirror each other, mirrors show the map as it is.
    return one.scene.environment && one.surface.material.reflection != Reflection::none &&
           one.is_alone();
}

bool mirrors_shadows(const scene::OneSurface& one) {
    return one.surface.material.reflection == Reflection::self && shadow_mask(one.scene) != 0 &&
           one.is_alone();
}

std::optional<formula::Program> mirror_hessian(const scene::OneSurface& one) {
    constexpr std::size_t longest = 1000; // some 0.2 s to compile on a software renderer
    if (!mirrors_environment(one)) return std::nullopt;
    const formula::Field& field = *one.surface.field;
    if (field.gradient.instructions.size() > longest) return std::nullopt;
    formula::Program second = formula::hessian(field);
    if (second.instructions.size() > longest) return std::nullopt;
    return second;
}

int far_lights(const scene::Scene& scene) {
    int mask = 0;
    for (std::size_t k = 0; k < scene.lights.size(); ++k)
        mask |= int(!scene.lights[k].is_point) << k;
    return mask;
}

void add_lights(ShaderText& text, const scene::Scene& scene) {
    const bool near = far_lights(scene) != (1 << scene.lights.size()) - 1;
    if (near) text.define(Feature::near_lights);
    text.file("effects/lights.glsl");
}

void add_shading(ShaderText& text, const scene::OneSurface& one) {
    const Reflection reflection = one.surface.material.reflection;
    const bool has_shadows = shadow_mask(one.scene) != 0;
    add_lights(text, one.scene);
    if (mirrors_environment(one)) {
        text.define(Feature::footprint);
        if (mirror_hessian(one)) text.define(Feature::hessian);
        text.file("effects/footprint.glsl");
    }
    if (!one.scene.sections.empty()) text.file("section/distance.glsl");
    if (mirrors_shadows(one)) text.define(Feature::mirrored_shadows);
    if (one.is_alone() && shows_shadows_through_glass(one)) text.define(Feature::glass_shadows);
    add_effects(text, one, false);

    if (follows_paths(one.scene)) {
        add_matter_of_surface(text, one);
        add_seen_by_path(text, one);
    } else if (has_glass(one)) {
        add_matter(text, one);
        add_seen_through_glass(text, one);
    }
    // Glass has declared it.
    const bool has_glass_alone = has_glass(one) && one.is_alone();
    std::string glue = one.scene.ground && !has_glass_alone ? "uniform vec4 ground_color;\n" : "";
    glue += lit(one, "lit", has_shadows ? "visibility" : nullptr, true);
    if (reflection == Reflection::self && one.is_alone())
        glue +=
            lit(one, "lit_again", mirrors_shadows(one) ? "mirrored_visibility" : nullptr, false);
    if (reflection != Reflection::none) glue += mirrored(one);
    glue += "vec3 shade(Ray ray, SurfacePoint p, Hit hit) {\n";
    if (mirrors_environment(one)) {
        glue += "    float turn = turn_of_normal(p, ray.direction, p.pixel);\n"
                "    footprint_alpha2 = turn * turn / 48.0;\n";
    }
    glue += "    vec3 color = lit(p, hit, -ray.direction);\n";
    if (reflection != Reflection::none) glue += "    color = mirrored(color, ray, p, hit);\n";
    if (follows_paths(one.scene)) glue += "    color = with_path(color);\n";
    if (has_glass_alone) glue += "    color = with_glass(color, ray, p);\n";
    if (one.scene.fog) glue += "    color = in_fog(color, p.t - eye_begin(ray));\n";
    glue += "    return color;\n}\n";
    if (follows_paths(one.scene)) text.file("paths/packed_shadows.glsl");
    glue += further_record(one);
    text.generated("generated: what shines and what it passes through", glue);
}

void add_lit_again(ShaderText& text, const scene::OneSurface& one) {
    add_lights(text, one.scene);
    add_effects(text, one, true);
    add_matter_of_surface(text, one);
    text.generated("generated: what shines on a surface in the middle of a path",
                   lit(one, "lit_again", nullptr, false));
}

void add_seen_shading(ShaderText& text, const scene::OneSurface& one) {
    add_lights(text, one.scene);
    add_effects(text, one, true);
    if (follows_paths(one.scene)) add_matter_of_surface(text, one);
    const bool mirrors = one.surface.material.reflection != Reflection::none;
    std::string glue = one.scene.ground ? "uniform vec4 ground_color;\n" : "";
    const bool in_shadow = follows_paths(one.scene) && shadow_mask(one.scene) != 0;
    glue += lit(one, "lit_again", in_shadow ? "visibility" : nullptr, false);
    if (mirrors) glue += with_mirror(one);
    // A mirror in a mirror shows what is around.
    glue += "vec3 seen_again(SurfacePoint q, Hit hit, vec3 direction) {\n"
            "    vec3 color = lit_again(q, hit, -direction);\n";
    if (mirrors) {
        glue += fmt::format("    if (is_on_surface(q)) color = with_mirror(color, hit, -direction, "
                            "{});\n",
                            around(one, "reflect(direction, q.normal)"));
    }
    text.generated("generated: what shines on what is seen in a mirror",
                   glue + "    return color;\n}\n");
}

} // namespace isomotion::shader
