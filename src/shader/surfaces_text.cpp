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
    if (one.is_alone()) {
        text.file("effects/load_surface.glsl");
        return;
    }
    text.generated("load_surface() of stored ends, renamed",
                   "#define load_surface load_as_it_is\n");
    text.file("effects/load_surface.glsl");
    text.generated("load_surface() in this surface's coordinates", "#undef load_surface\n");
    text.define(Feature::surfaces, int(one.scene.surfaces.size()));
    text.file("surfaces/load_moved.glsl");
}

void add_mirror_ray(ShaderText& text, const scene::OneSurface& one) {
    if (one.is_alone()) {
        text.file("effects/mirror_ray.glsl");
        return;
    }
    text.generated("mirrored rays of all pixels, renamed", "#define pixel_ray mirrored_ray\n");
    text.file("effects/mirror_ray.glsl");
    text.generated("mirrored rays of pixels that see a mirror", "#undef pixel_ray\n");
    text.define(Feature::mirrors, scene::mirrors(one.scene));
    text.file("surfaces/mirror_ray.glsl");
}

namespace {

bool ends_before(const scene::OneSurface& one, Origin origin) {
    return !one.is_alone() && one.index != 0 && origin != Origin::mirror;
}

} // namespace

void begin_entrance(ShaderText& text, const scene::OneSurface& one, Origin origin) {
    if (!ends_before(one, origin)) return;
    text.generated("enter_beam() by this surface's bounds, renamed",
                   "#define enter_beam enter_own_beam\n");
}

void end_entrance(ShaderText& text, const scene::OneSurface& one, Origin origin, Draws draws) {
    if (!ends_before(one, origin)) return;
    text.generated("enter_beam() that ends at the surfaces before", "#undef enter_beam\n");
    text.file("surfaces/eye_way.glsl");
    text.file(draws == Draws::one ? "surfaces/way_of_picture.glsl" : "surfaces/way_of_ends.glsl");
    text.file("surfaces/enter_before.glsl");
}

void add_store_nearest(ShaderText& text, const scene::OneSurface& one, Origin origin) {
    const bool of_eye = origin == Origin::eye;
    text.define(Feature::surface, one.index);
    text.file(of_eye ? "surfaces/eye_way.glsl" : "surfaces/mirror_way.glsl");
    text.file("surfaces/nearest.glsl");
    if (one.index == 0) {
        text.file("surfaces/first.glsl");
        return;
    }
    const char* kind = origin == Origin::mirror ? "mirrored" : "surface";
    std::string samplers, reads;
    for (int k = 0; k < 4; ++k) {
        samplers += fmt::format("uniform sampler2D {}_texture_{};\n", kind, k);
        reads += fmt::format("    if (k == {0}) return texelFetch({1}_texture_{0}, "
                             "ivec2(pixel_centre), 0);\n",
                             k, kind);
    }
    // Mirrored rays have declared none of these.
    text.generated("generated: the nearest so far",
                   samplers + "vec4 before(int k) {\n" + reads + "    return vec4(0.0);\n}\n");
    text.file("surfaces/least_nearer.glsl");
    text.file("surfaces/next.glsl");
}

void add_keep_nearest(ShaderText& text, const scene::OneSurface& one, const Passes& passes) {
    text.file("surfaces/eye_way.glsl");
    text.define(Feature::way_location, way_attachment(passes));
    text.file("surfaces/seen_way.glsl");
    if (one.index == 0) {
        text.file("surfaces/keep_first.glsl");
        return;
    }
    text.file("surfaces/least_nearer.glsl");
    text.file("surfaces/keep_nearest.glsl");
}

void agree_on_draws(std::vector<Passes*> all) {
    const auto is_fused = [](const Passes* passes) { return passes->has(Role::fused); };
    if (std::ranges::all_of(all, is_fused)) return;
    for (Passes* passes : all) *passes = without_fused_pass(std::move(*passes));
}

void begin_shadow_after_others(ShaderText& text, const scene::OneSurface& one, int mask) {
    if (one.is_alone() || one.index == 0) {
        text.file("effects/begin_lights.glsl");
        return;
    }
    text.file("surfaces/shadow_begin.glsl");
    text.generated("rays begin for the lights that others leave",
                   fmt::format("#undef SHADOWS\n#define SHADOWS ({} & ~s.verdict)\n", mask));
}

Pass mirror_mask_pass(const scene::Scene& scene) {
    ShaderText text;
    text.file("march/verdict.glsl");
    text.define(Feature::mirrors, scene::mirrors(scene));
    text.file("surfaces/mirror_mask.frag");
    return std::move(text).pass(Role::mirror_mask, "mirror mask", When::once_a_tile);
}

Pass occlusion_pass(const scene::OneSurface& one, const Passes& passes) {
    ShaderText text;
    add_field(text, *one.surface.field, passes, {FieldFunction::value, FieldFunction::gradient});
    add_ray(text, one);
    if (!one.scene.sections.empty()) text.file("section/distance.glsl");
    text.file("effects/surface_point.glsl");
    add_load_surface(text, one);
    text.define(Feature::surface, one.index);
    text.generated("generated: what the surfaces before leave",
                   one.index == 0 ? "float open_before() {\n    return 1.0;\n}\n"
                                  : "uniform sampler2D occlusion_texture;\n"
                                    "float open_before() {\n    return texelFetch("
                                    "occlusion_texture, ivec2(pixel_centre), 0).x;\n}\n");
    text.file("surfaces/occlusion.frag");
    return std::move(text).pass(Role::occlusion, "occlusion", When::once_a_tile);
}

} // namespace isomotion::shader
