#include "synthesis/paths_text.h"

#include <fmt/format.h>

#include "scene/limits.h"
#include "scene/surfaces.h"
#include "synthesis/effect_text.h"
#include "synthesis/glass_text.h"
#include "synthesis/paint_text.h"
#include "synthesis/section_text.h"
#include "synthesis/shade_text.h"
#include "synthesis/surfaces_text.h"

namespace isomotion::synthesis {
namespace {

using Reflection = scene::Material::Reflection;

bool mirrors_all(const scene::Scene& scene) {
    return scene.surface.material.reflection == Reflection::self;
}

// Whether its own light is part of a path that goes on.
bool shines_on_paths(const scene::Scene& scene) { return has_glass(scene) || mirrors_all(scene); }

// What shaders/paths/store_path.glsl packs into floats, which are whole to 2^24.
static_assert(scene::most_surfaces <= 8 && scene::limits::sections < 15);
static_assert(scene::limits::glass_depth < 32 && (most_crossings + 1) << 5 < 1 << 24);

void add_path(ShaderText& text, const scene::Scene& scene) {
    text.define("SURFACES", scene.among.count);
    text.define("SURFACE", scene.among.index);
    if (has_glass(scene)) text.define("GLASS", 1);
    text.file("paths/path.glsl");
}

// What the ends of rays are, in this surface's coordinates.
void add_ends(ShaderText& text, const scene::Scene& scene) {
    text.file("effects/surface_point.glsl");
    add_load_surface(text, scene);
}

void add_glass_met(ShaderText& text, const scene::Scene& scene) {
    text.file("paths/meet_glass.glsl");
    text.generated("the index of refraction is that of the boundary", "#define glass boundary\n");
    text.file("glass/refraction.glsl");
    text.generated("and again that of the surface", "#undef glass\n");
    text.file("glass/through.glsl");
    text.generated("generated: how much goes in", transmission(scene) + beside_reflection(scene));
    text.file("paths/through_glass.glsl");
}

// beside_mirror(): the weight of the surface's own colour. The matt part of other materials is what
// their highlight leaves; a matt one gets a clear coat.
std::string beside_mirror(const scene::Scene& scene) {
    const bool matt = scene.surface.material.model == scene::Material::Model::lambert;
    return fmt::format("vec3 beside_mirror(vec3 mirror) {{\n    return vec3(1.0){};\n}}\n",
                       matt ? " - mirror" : "");
}

// meet(), with_ground() and what they need, after the field and the ray.
void add_meeting(ShaderText& text, const scene::Scene& scene, const Passes& passes) {
    add_picture(text, scene);
    if (shines_on_paths(scene)) add_color(text, scene);
    add_ends(text, scene);
    add_gradient(text, scene, passes);
    if (!scene.sections.empty()) text.file("section/distance.glsl");
    text.file("effects/end_of_ray.glsl");
    add_path(text, scene);
    text.file("paths/matter.glsl");
    add_surroundings(text, scene);
    text.file("glass/behind.glsl");
    if (shines_on_paths(scene)) add_lit_again(text, scene);
    if (has_glass(scene)) {
        add_glass_met(text, scene);
    } else if (mirrors_all(scene)) {
        text.generated("generated: beside the mirror", beside_mirror(scene));
        text.file("paths/meet_mirror.glsl");
    } else {
        text.file("paths/meet_opaque.glsl");
    }
    if (scene.ground) {
        text.file("paths/on_ground.glsl");
    } else {
        text.generated("generated: no path ends on the ground",
                       "Path with_ground(Path path) {\n    return path;\n}\n");
    }
    text.file("paths/store_path.glsl");
}

void add_field_of_meeting(ShaderText& text, const scene::Scene& scene, const Passes& passes) {
    std::vector<FieldFunction> functions{FieldFunction::value};
    if (!passes.march_takes_gradient) functions.push_back(FieldFunction::gradient);
    add_field(text, *scene.surface.field, passes, functions,
              shines_on_paths(scene) ? painting_functions(scene, passes)
                                     : std::vector<GeneratedFunction>{});
}

Pass meeting_pass(const scene::Scene& scene, const Passes& passes, Role role, const char* name,
                  const char* file, Cover cover) {
    ShaderText text;
    text.define("LIGHTS", int(scene.lights.size()));
    add_field_of_meeting(text, scene, passes);
    add_ray(text, scene);
    add_meeting(text, scene, passes);
    text.define("MOST_CROSSINGS", most_crossings);
    text.file(file);
    const When when = role == Role::glass_first ? When::once_a_tile : When::until_rays_end;
    return std::move(text).pass(role, name, when, cover);
}

Pass beyond_pass(const scene::Scene& scene, const Passes& passes) {
    ShaderText text;
    add_field(text, *scene.surface.field, passes, {FieldFunction::value});
    add_ray(text, scene);
    add_ends(text, scene);
    text.define("SURFACE", scene.among.index);
    text.file("paths/in_matter.glsl");
    text.file("paths/beyond.frag");
    return std::move(text).pass(Role::glass_beyond, "glass beyond", When::until_rays_end,
                                Cover{Cover::Area::rectangles});
}

Pass path_pass(const scene::Scene& scene, Role role, const char* name, const char* file) {
    ShaderText text;
    add_path(text, scene);
    return pass_over_paths(std::move(text), role, name, file, Cover{Cover::Area::rectangles});
}

// Where paths begin on this surface, or before it.
Pass begins_pass(const scene::Scene& scene) {
    ShaderText text;
    text.file("march/verdict.glsl");
    text.define("SURFACE", scene.among.index);
    text.file("paths/begins.frag");
    return std::move(text).pass(Role::glass_begins, "glass begins", When::once_a_tile);
}

Pass ended_pass(const scene::Scene& scene) {
    ShaderText text;
    add_path(text, scene);
    text.file("paths/ended.frag");
    return std::move(text).pass(Role::glass_ended, "glass ended", When::once_a_tile);
}

Pass ends_pass(const scene::Scene& scene) {
    ShaderText text;
    text.file("math/bits.glsl");
    add_ray(text, scene);
    text.file("effects/surface_point.glsl");
    text.file("effects/store_surface.glsl");
    add_path(text, scene);
    text.file("paths/ends.frag");
    return std::move(text).pass(Role::glass_ground, "ends of paths", When::once_a_tile);
}

Pass seen_by_paths_pass(const scene::Scene& scene, const Passes& passes) {
    ShaderText text = begin_seen(scene, passes);
    text.file("effects/load_mirrored.glsl");
    add_path(text, scene);
    add_seen_shading(text, scene);
    if (painting(scene)) add_gradient(text, scene, passes);
    text.file("paths/packed_shadows.glsl");
    text.generated("generated: what shadow rays took",
                   fmt::format("float shadows_here() {{\n    return {};\n}}\n",
                               shadow_mask(scene) != 0
                                   ? "packed_shadows(texelFetch(shadow_texture, "
                                     "ivec2(pixel_centre), 0))"
                                   : "0.0"));
    text.file("paths/seen.frag");
    return std::move(text).pass(Role::seen, "seen", When::once_a_tile);
}

} // namespace

void add_path_ray(ShaderText& text, const scene::Scene& scene) {
    add_path(text, scene);
    text.file("paths/matter.glsl");
    text.file("paths/may_meet.glsl");
    text.file("glass/ray.glsl");
}

void add_begin_of_path(ShaderText& text, const scene::Scene& scene) {
    if (has_glass(scene)) {
        add_path(text, scene);
        text.file("paths/matter.glsl");
        text.file("paths/in_matter.glsl");
    }
    text.generated("generated: where rays begin in the matter of surfaces before",
                   is_first(scene)
                       ? "vec4 begin_before() {\n    return vec4(NO_END, 0.0, 0.0, 0.0);\n}\n"
                       : "uniform sampler2D surface_texture_4;\n"
                         "vec4 begin_before() {\n    return texelFetch(surface_texture_4, "
                         "ivec2(pixel_centre), 0);\n}\n");
    text.file("paths/begin.glsl");
}

void add_end_at_bounds(ShaderText& text) {
    text.file("paths/in_matter.glsl");
    text.file("paths/at_bounds.glsl");
}

void add_matter_of_surface(ShaderText& text, const scene::Scene& scene) {
    if (!has_glass(scene)) return;
    text.generated("generated: the part of what is matt that is as without glass",
                   "uniform vec4 glass; // transmission, index of refraction\n" + opaque_part());
    if (scene.surface.material.model == scene::Material::Model::ggx)
        text.file("glass/matt_ggx.glsl");
}

void add_seen_by_path(ShaderText& text, const scene::Scene& scene) {
    add_path(text, scene);
    text.file("surfaces/seen.glsl");
    text.file("paths/with_path.glsl");
    if (mirrors_all(scene)) text.generated("generated: beside the mirror", beside_mirror(scene));
}

std::vector<Pass> path_passes(const scene::Scene& scene, const Passes& passes) {
    std::vector<Pass> all;
    all.push_back(begins_pass(scene));
    all.push_back(
        meeting_pass(scene, passes, Role::glass_first, "glass first", "paths/first.frag", Cover{}));
    all.push_back(march_pass(scene, passes, Origin::glass, When::until_rays_end));
    all.push_back(surface_pass(scene, passes, Origin::glass, When::until_rays_end));
    if (has_glass(scene)) all.push_back(beyond_pass(scene, passes));
    all.push_back(meeting_pass(scene, passes, Role::glass_next, "glass next", "paths/next.frag",
                               Cover{Cover::Area::rectangles}));
    if (is_first(scene)) {
        all.push_back(path_pass(scene, Role::glass_copy, "glass copy", "paths/copy.frag"));
        all.push_back(path_pass(scene, Role::glass_mask, "glass mask", "glass/mask.frag"));
        all.push_back(ended_pass(scene));
        all.push_back(ends_pass(scene));
    }
    all.push_back(seen_by_paths_pass(scene, passes));
    return all;
}

} // namespace isomotion::synthesis
