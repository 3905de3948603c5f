#include "shader/paths_text.h"

#include <fmt/format.h>

#include "scene/limits.h"
#include "scene/surfaces.h"
#include "shader/effect_text.h"
#include "shader/glass_text.h"
#include "shader/paint_text.h"
#include "shader/section_text.h"
#include "shader/shade_text.h"
#include "shader/surfaces_text.h"

namespace isomotion::shader {
namespace {

using Reflection = scene::Material::Reflection;

bool mirrors_all(const scene::OneSurface& one) {
    return one.surface.material.reflection == Reflection::self;
}

// Whether its own light is part of a path that goes on.
bool shines_on_paths(const scene::OneSurface& one) { return has_glass(one) || mirrors_all(one); }

// What shaders/paths/path.glsl packs into floats, which are whole to 2^24.
static_assert(scene::most_surfaces <= 8 && scene::limits::sections < 15);
static_assert(scene::limits::glass_depth < 32 && (most_crossings + 1) << 5 < 1 << 24);

void add_path(ShaderText& text, const scene::OneSurface& one) {
    text.define(Feature::surfaces, int(one.scene.surfaces.size()));
    text.define(Feature::surface, one.index);
    text.define(Feature::follows_paths);
    if (has_glass(one)) text.define(Feature::glass);
    text.file("paths/path.glsl");
}

// What the ends of rays are, in this surface's coordinates.
void add_ends(ShaderText& text, const scene::OneSurface& one) {
    text.file("effects/surface_point.glsl");
    add_load_surface(text, one);
}

void add_glass_met(ShaderText& text, const scene::OneSurface& one) {
    text.file("glass/refraction.glsl");
    text.file("glass/through.glsl");
    text.generated("generated: how much goes in", transmission(one) + beside_reflection(one));
}

// beside_mirror(): the weight of the surface's own colour. The matt part of other materials is what
// their highlight leaves; a matt one gets a clear coat.
std::string beside_mirror(const scene::OneSurface& one) {
    const bool matt = one.surface.material.model == scene::Material::Model::lambert;
    return fmt::format("vec3 beside_mirror(vec3 mirror) {{\n    return vec3(1.0){};\n}}\n",
                       matt ? " - mirror" : "");
}

// meet(), with_ground() and what they need, after the field and the ray.
void add_meeting(ShaderText& text, const scene::OneSurface& one, const PassPlan& plan) {
    add_picture(text, one);
    if (shines_on_paths(one)) add_color(text, one);
    add_ends(text, one);
    add_gradient(text, plan);
    if (!one.scene.sections.empty()) text.file("section/distance.glsl");
    text.file("effects/end_of_ray.glsl");
    add_path(text, one);
    text.file("paths/matter.glsl");
    add_surroundings(text, one.scene);
    if (shines_on_paths(one)) add_lit_again(text, one);
    if (has_glass(one)) {
        add_glass_met(text, one);
    } else if (mirrors_all(one)) {
        text.define(Feature::mirrors_all);
        text.generated("generated: beside the mirror", beside_mirror(one));
    }
    text.file("paths/meet.glsl");
}

void add_field_of_meeting(ShaderText& text, const scene::OneSurface& one, const PassPlan& plan) {
    std::vector<FieldFunction> functions{FieldFunction::value};
    if (!plan.march_takes_gradient) functions.push_back(FieldFunction::gradient);
    add_field(text, *one.surface.field, plan, functions,
              shines_on_paths(one) ? painting_functions(one, plan)
                                   : std::vector<GeneratedFunction>{});
}

Pass meeting_pass(const scene::OneSurface& one, const PassPlan& plan, Role role, const char* name,
                  const char* file, Cover cover) {
    ShaderText text;
    text.define(Feature::stores_paths);
    text.define(Feature::lights, int(one.scene.lights.size()));
    add_field_of_meeting(text, one, plan);
    add_ray(text, one);
    add_meeting(text, one, plan);
    text.define(Feature::most_crossings, most_crossings);
    text.file(file);
    const When when = role == Role::glass_first ? When::once_a_tile : When::until_rays_end;
    return std::move(text).pass(role, name, when, cover);
}

Pass beyond_pass(const scene::OneSurface& one, const PassPlan& plan) {
    ShaderText text;
    add_field(text, *one.surface.field, plan, {FieldFunction::value});
    add_ray(text, one);
    add_ends(text, one);
    text.define(Feature::glass);
    text.file("paths/bounds.glsl");
    text.file("paths/beyond.frag");
    return std::move(text).pass(Role::glass_beyond, "glass beyond", When::until_rays_end,
                                Cover{Cover::Area::rectangles});
}

Pass path_pass(const scene::OneSurface& one, Role role, const char* name, const char* file) {
    ShaderText text;
    add_path(text, one);
    return pass_over_paths(std::move(text), role, name, file, Cover{Cover::Area::rectangles});
}

// Where paths begin on this surface, or before it.
Pass begins_pass(const scene::OneSurface& one) {
    ShaderText text;
    text.file("march/verdict.glsl");
    text.define(Feature::surface, one.index);
    text.file("paths/begins.frag");
    return std::move(text).pass(Role::glass_begins, "glass begins", When::once_a_tile);
}

Pass ended_pass(const scene::OneSurface& one) {
    ShaderText text;
    text.define(Feature::ended_paths);
    add_path(text, one);
    text.file("glass/mask.frag");
    return std::move(text).pass(Role::glass_ended, "glass ended", When::once_a_tile);
}

Pass ends_pass(const scene::OneSurface& one) {
    ShaderText text;
    text.file("math/bits.glsl");
    add_ray(text, one);
    text.file("effects/surface_point.glsl");
    text.file("effects/store_surface.glsl");
    add_path(text, one);
    text.file("paths/ends.frag");
    return std::move(text).pass(Role::glass_ground, "ends of paths", When::once_a_tile);
}

Pass seen_by_paths_pass(const scene::OneSurface& one, const PassPlan& plan) {
    ShaderText text = begin_seen(one, plan);
    text.file("effects/load_mirrored.glsl");
    add_path(text, one);
    add_seen_shading(text, one);
    if (painting(one)) add_gradient(text, plan);
    text.file("paths/packed_shadows.glsl");
    text.generated("generated: what shadow rays took",
                   fmt::format("float shadows_here() {{\n    return {};\n}}\n",
                               shadow_mask(one.scene) != 0
                                   ? "packed_shadows(IM_TEXEL(shadow_texture, "
                                     "ivec2(pixel_centre)))"
                                   : "0.0"));
    text.file("surfaces/seen.frag");
    return std::move(text).pass(Role::seen, "seen", When::once_a_tile);
}

} // namespace

void add_path_ray(ShaderText& text, const scene::OneSurface& one) {
    add_path(text, one);
    text.file("paths/matter.glsl");
    text.file("glass/ray.glsl");
}

void add_begin_of_path(ShaderText& text, const scene::OneSurface& one) {
    if (has_glass(one)) {
        add_path(text, one);
        text.file("paths/matter.glsl");
    }
    text.generated("generated: where rays begin in the matter of surfaces before",
                   one.index == 0
                       ? "vec4 begin_before() {\n    return vec4(NO_END, 0.0, 0.0, 0.0);\n}\n"
                       : "uniform sampler2D surface_texture_4;\n"
                         "vec4 begin_before() {\n    return IM_TEXEL(surface_texture_4, "
                         "ivec2(pixel_centre));\n}\n");
    text.define(Feature::begins_paths);
    text.file("paths/bounds.glsl");
}

void add_end_at_bounds(ShaderText& text) {
    text.define(Feature::ends_at_bounds);
    text.file("paths/bounds.glsl");
}

void add_matter_of_surface(ShaderText& text, const scene::OneSurface& one) {
    if (!has_glass(one)) return;
    text.generated("generated: the part of what is matt that is as without glass",
                   "uniform vec4 glass; // transmission, index of refraction\n" + opaque_part());
    if (one.surface.material.model == scene::Material::Model::ggx) text.file("glass/matt_ggx.glsl");
}

void add_seen_by_path(ShaderText& text, const scene::OneSurface& one) {
    add_path(text, one);
    text.file("surfaces/seen.glsl");
    text.file("paths/with_path.glsl");
    if (mirrors_all(one)) text.generated("generated: beside the mirror", beside_mirror(one));
}

std::vector<Pass> path_passes(const scene::OneSurface& one, const PassPlan& plan) {
    std::vector<Pass> all;
    all.push_back(begins_pass(one));
    all.push_back(
        meeting_pass(one, plan, Role::glass_first, "glass first", "paths/first.frag", Cover{}));
    all.push_back(march_pass(one, plan, Origin::glass, When::until_rays_end));
    all.push_back(surface_pass(one, plan, Origin::glass, When::until_rays_end));
    if (has_glass(one)) all.push_back(beyond_pass(one, plan));
    all.push_back(meeting_pass(one, plan, Role::glass_next, "glass next", "paths/next.frag",
                               Cover{Cover::Area::rectangles}));
    if (one.index == 0) {
        all.push_back(path_pass(one, Role::glass_copy, "glass copy", "glass/copy.frag"));
        all.push_back(path_pass(one, Role::glass_mask, "glass mask", "glass/mask.frag"));
        all.push_back(ended_pass(one));
        all.push_back(ends_pass(one));
    }
    all.push_back(seen_by_paths_pass(one, plan));
    return all;
}

} // namespace isomotion::shader
