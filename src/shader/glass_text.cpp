#include "shader/glass_text.h"

#include <fmt/format.h>

#include "shader/effect_text.h"
#include "shader/march_text.h"
#include "shader/section_text.h"
#include "shader/shade_text.h"
#include "shader/shader_files.h"

namespace isomotion::shader {
namespace {

using Model = scene::Material::Model;

void add_ground(ShaderText& text, const scene::Scene& scene) {
    if (scene.ground) {
        text.define(Feature::ground);
        add_lights(text, scene);
    }
    text.file("glass/ground.glsl");
}

// through(), of places that end_of_ray() tells of.
void add_way_through(ShaderText& text, const scene::Scene& scene) {
    if (!scene.sections.empty()) text.file("section/distance.glsl");
    text.file("effects/end_of_ray.glsl");
    text.file("glass/refraction.glsl");
    add_surroundings(text, scene);
    text.file("glass/through.glsl");
}

Pass first_pass(const scene::OneSurface& one, const PassPlan& plan) {
    ShaderText text;
    text.define(Feature::stores_paths);
    text.define(Feature::lights, int(one.scene.lights.size()));
    add_field(text, *one.surface.field, plan, {FieldFunction::value});
    add_ray(text, one);
    text.file("shade/shading.glsl");
    text.file("effects/surface_point.glsl");
    text.file("effects/load_surface.glsl");
    text.file("glass/path.glsl");
    text.generated(
        "generated: no ray ends here",
        "vec3 surface_gradient(RayState s, vec3 position) {\n    return vec3(0.0);\n}\n");
    add_way_through(text, one.scene);
    const bool is_ggx = one.surface.material.model == Model::ggx;
    text.generated("generated: how much goes in",
                   (is_ggx ? "uniform vec4 gloss;\n" : "") + transmission(one));
    text.file("glass/first.frag");
    return std::move(text).pass(Role::glass_first, "glass first", When::once_a_tile);
}

Pass next_pass(const scene::OneSurface& one, const PassPlan& plan) {
    ShaderText text;
    text.define(Feature::stores_paths);
    text.define(Feature::lights, int(one.scene.lights.size()));
    std::vector<FieldFunction> functions{FieldFunction::value};
    if (!plan.march_takes_gradient) functions.push_back(FieldFunction::gradient);
    add_field(text, *one.surface.field, plan, functions);
    add_ray(text, one, Origin::glass);
    text.file("shade/shading.glsl");
    text.file("effects/surface_point.glsl");
    add_gradient(text, plan);
    add_way_through(text, one.scene);
    text.file("glass/next.frag");
    return std::move(text).pass(Role::glass_next, "glass next", When::until_rays_end);
}

Pass path_pass(Role role, const char* name, const char* file) {
    ShaderText text;
    if (role == Role::glass_copy) text.define(Feature::stores_paths);
    if (role == Role::glass_active) text.define(Feature::counts_rays);
    text.file("glass/path.glsl");
    return pass_over_paths(std::move(text), role, name, file);
}

Pass ground_pass(const scene::OneSurface& one) {
    ShaderText text;
    text.file("math/bits.glsl");
    add_ray(text, one);
    text.file("effects/surface_point.glsl");
    text.file("effects/load_surface.glsl");
    text.file("effects/store_surface.glsl");
    text.file("glass/path.glsl");
    text.define(Feature::ground);
    text.file("glass/ground.glsl");
    text.file("glass/ground_end.frag");
    return std::move(text).pass(Role::glass_ground, "ground through glass", When::once_a_tile);
}

} // namespace

std::string beside_reflection(const scene::OneSurface& one) {
    const bool matt = one.surface.material.model == Model::lambert;
    return fmt::format("float beside_reflection(float reflected) {{\n    return {};\n}}\n",
                       matt ? "1.0 - reflected" : "1.0");
}

std::string transmission(const scene::OneSurface& one) {
    // Metal lets no light in.
    const bool is_ggx = one.surface.material.model == Model::ggx;
    return fmt::format("float transmission() {{\n    return glass.x{};\n}}\n",
                       is_ggx ? " * (1.0 - gloss.y)" : "");
}

std::string opaque_part() { return "float opaque_part() {\n    return 1.0 - glass.x;\n}\n"; }

void add_surroundings(ShaderText& text, const scene::Scene& scene) {
    if (scene.environment) {
        for (const auto& file : kernel_files({"atan"})) text.file(file);
        text.define(Feature::environment);
        text.file("effects/environment.glsl");
    }
    add_sky(text, scene);
    add_ground(text, scene);
    if (scene.output.transparent) text.define(Feature::transparent);
    text.file("glass/surroundings.glsl");
}

bool shows_shadows_through_glass(const scene::OneSurface& one) {
    return has_glass(one) && one.scene.ground && shadow_mask(one.scene) != 0;
}

void add_glass_ray(ShaderText& text) {
    text.file("glass/path.glsl");
    text.file("glass/ray.glsl");
}

void add_matter(ShaderText& text, const scene::OneSurface& one) {
    text.file("glass/path.glsl");
    text.file("glass/refraction.glsl");
    text.generated("generated: the part of what is matt that is as without glass", opaque_part());
    if (one.surface.material.model == Model::ggx) text.file("glass/matt_ggx.glsl");
}

void add_seen_through_glass(ShaderText& text, const scene::OneSurface& one) {
    if (one.scene.ground) add_ground(text, one.scene);
    text.generated(
        "generated: what is seen through glass",
        beside_reflection(one) +
            fmt::format("vec3 ground_through_glass(Path path) {{\n    return {};\n}}\n",
                        one.scene.ground
                            ? "ground_light(path.position, ground_normal(path.direction))"
                            : "vec3(0.0)"));
    text.file("glass/seen.glsl");
}

Pass pass_over_paths(ShaderText text, Role role, const char* name, const char* file, Cover cover) {
    text.file(file);
    return std::move(text).pass(role, name, When::until_rays_end, cover);
}

std::vector<Pass> glass_passes(const scene::OneSurface& one, const PassPlan& plan) {
    std::vector<Pass> all;
    all.push_back(first_pass(one, plan));
    all.push_back(march_pass(one, plan, Origin::glass, When::until_rays_end));
    all.push_back(next_pass(one, plan));
    all.push_back(path_pass(Role::glass_copy, "glass copy", "glass/copy.frag"));
    all.push_back(path_pass(Role::glass_mask, "glass mask", "glass/mask.frag"));
    all.push_back(path_pass(Role::glass_active, "glass active", "glass/mask.frag"));
    if (shows_shadows_through_glass(one)) all.push_back(ground_pass(one));
    return all;
}

} // namespace isomotion::shader
