#include "shader/surfaces_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "scene/surfaces.h"
#include "shader/paths_text.h"

namespace isomotion::shader {

bool has_mirrored_rays(const scene::OneSurface& one) {
    if (follows_paths(one.scene)) return false; // they are rays of paths
    return one.surface.material.reflection == scene::Material::Reflection::self ||
           (!one.is_alone() && scene::mirrors(one.scene) != 0);
}

void add_load_surface(ShaderText& text, const scene::OneSurface& one) {
    if (!one.is_alone()) {
        text.define(Feature::moved_ends);
        text.define(Feature::surfaces, int(one.scene.surfaces.size()));
    }
    text.file("effects/load_surface.glsl");
}

void add_mirror_ray(ShaderText& text, const scene::OneSurface& one) {
    if (!one.is_alone()) text.define(Feature::mirrors, scene::mirrors(one.scene));
    text.file("effects/mirror_ray.glsl");
}

void add_ways(ShaderText& text, const scene::OneSurface& one, Origin origin) {
    if (one.is_alone() || one.index == 0 || origin == Origin::mirror) return;
    text.define(Feature::ends_before);
    text.file("surfaces/way.glsl");
}

void add_store_nearest(ShaderText& text, const scene::OneSurface& one, Origin origin) {
    text.file("surfaces/way.glsl");
    if (one.index != 0) {
        const char* kind = origin == Origin::mirror ? "mirrored" : "surface";
        std::string samplers, reads;
        for (int k = 0; k < 4; ++k) {
            samplers += fmt::format("uniform sampler2D {}_texture_{};\n", kind, k);
            reads += fmt::format("    if (k == {0}) return IM_TEXEL({1}_texture_{0}, "
                                 "ivec2(pixel_centre));\n",
                                 k, kind);
        }
        // Mirrored rays have declared none of these.
        text.generated("generated: the nearest so far",
                       samplers + "vec4 before(int k) {\n" + reads + "    return vec4(0.0);\n}\n");
    }
    text.file("surfaces/nearest.glsl");
}

void agree_on_draws(std::vector<Passes*> all) {
    const auto is_fused = [](const Passes* passes) { return passes->has(Role::fused); };
    if (std::ranges::all_of(all, is_fused)) return;
    for (Passes* passes : all) *passes = without_fused_pass(std::move(*passes));
}

Pass mirror_mask_pass(const scene::Scene& scene) {
    ShaderText text;
    text.file("march/verdict.glsl");
    text.define(Feature::mirrors, scene::mirrors(scene));
    text.file("surfaces/mirror_mask.frag");
    return std::move(text).pass(Role::mirror_mask, "mirror mask", When::once_a_tile);
}

Pass occlusion_pass(const scene::OneSurface& one, const PassPlan& plan) {
    ShaderText text;
    add_field(text, *one.surface.field, plan, {FieldFunction::value, FieldFunction::gradient});
    add_ray(text, one);
    if (!one.scene.sections.empty()) text.file("section/distance.glsl");
    text.file("effects/surface_point.glsl");
    add_load_surface(text, one);
    text.generated("generated: what the surfaces before leave",
                   one.index == 0 ? "float open_before() {\n    return 1.0;\n}\n"
                                  : "uniform sampler2D occlusion_texture;\n"
                                    "float open_before() {\n    return IM_TEXEL("
                                    "occlusion_texture, ivec2(pixel_centre)).x;\n}\n");
    text.file("surfaces/occlusion.frag");
    return std::move(text).pass(Role::occlusion, "occlusion", When::once_a_tile);
}

} // namespace isomotion::shader
