#include "shader/shade_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "formula/hessian.h"
#include "shader/beam_copies_text.h"
#include "shader/beam_text.h"
#include "shader/effect.h"
#include "shader/effect_text.h"
#include "shader/glass_text.h"
#include "shader/paint_text.h"
#include "shader/paths_text.h"
#include "shader/section_text.h"
#include "shader/surfaces_text.h"

namespace isomotion::shader {
namespace {

bool contains(const std::vector<Channel>& channels, Channel channel) {
    return std::find(channels.begin(), channels.end(), channel) != channels.end();
}

struct ChannelOutput {
    Channel channel;
    Feature location;
    const char* output;
};

constexpr ChannelOutput channel_outputs[] = {
    {Channel::depth, Feature::depth_location, "depth_out"},
    {Channel::normal, Feature::normal_location, "normal_out"},
    {Channel::position, Feature::position_location, "position_out"},
    {Channel::cap, Feature::cap_location, "cap_out"},
    {Channel::surface, Feature::surface_location, "surface_out"},
    {Channel::ending, Feature::ending_location, "ending_out"},
};

// write_channels(), to the attachments from the third on. Surfaces that draw over each other have
// keep_channels() beside it.
void add_channels(ShaderText& text, const scene::OneSurface& one,
                  const std::vector<Channel>& written, Draws draws = Draws::several) {
    std::string samplers, kept;
    int location = 2;
    for (const ChannelOutput& to : channel_outputs) {
        if (!contains(written, to.channel)) continue;
        text.define(to.location, location);
        samplers += fmt::format("uniform sampler2D before_texture_{};\n", location);
        kept += fmt::format("    {} = IM_TEXEL(before_texture_{}, at){};\n", to.output, location,
                            to.channel == Channel::ending ? ".x" : "");
        ++location;
    }
    text.file("shade/channels.glsl");
    if (draws == Draws::one && one.index != 0)
        text.generated("generated: the channels of the surfaces before",
                       samplers + "void keep_channels(ivec2 at) {\n" + kept + "}\n");
}

// Whether colours take no more than the plain light.
bool is_plain(const scene::OneSurface& one) { return !calls_for_ends(one) && !painting(one); }

bool has_flat_shading(const scene::OneSurface& one, Draws draws) {
    const bool keeps = draws == Draws::one ? calls_for_ends(one) : keeps_surfaces(one);
    return one.scene.lights.size() == 1 && !keeps;
}

Cover cover(const scene::OneSurface& one, Draws draws, bool in_squares = false) {
    return {in_squares ? Cover::Area::squares : Cover::Area::whole, has_flat_shading(one, draws)};
}

// Whether rays or samples begin where others ended.
bool sees_from_surfaces(const scene::OneSurface& one) {
    return shadow_mask(one.scene) != 0 || has_mirrored_rays(one) || follows_paths(one.scene) ||
           one.scene.occlusion;
}

} // namespace

void add_gradient(ShaderText& text, const PassPlan& plan) {
    if (plan.march_takes_gradient) text.define(Feature::march_takes_gradient);
    text.file("shade/gradient.glsl");
}

void add_color(ShaderText& text, const scene::OneSurface& one) {
    const scene::Material& material = one.surface.material;
    if (has_cap_color(one)) text.define(Feature::cap_color);
    // A number's colour is that of both sides.
    if (material.inside && !material.paint) text.define(Feature::two_sides);
    if (painting(one)) add_painting(text, one);
    if (material.contours) {
        text.define(Feature::contours);
        text.file("effects/contours.glsl");
    }
    text.file("shade/color.glsl");
}

void add_picture(ShaderText& text, const scene::OneSurface& one, Draws draws) {
    if (has_flat_shading(one, draws)) text.define(Feature::flat_shading);
    text.file("shade/shading.glsl");
    text.define(Feature::hits);
    text.file("shade/hit.glsl");
}

std::vector<Channel> written_channels(const std::vector<Channel>& channels) {
    std::vector<Channel> written;
    for (const ChannelOutput& to : channel_outputs) {
        if (contains(channels, to.channel)) written.push_back(to.channel);
    }
    return written;
}

bool can_fuse(const scene::OneSurface& one, const std::vector<Channel>& channels, int attachments) {
    // OpenGL has 8 at least: colour, record, these, and of several surfaces the way to the nearest.
    constexpr int most = 8;
    const int drawn = 2 + attachments + (!one.is_alone() ? 1 : 0);
    return is_plain(one) && !contains(channels, Channel::velocity) && drawn <= most;
}

namespace {

// Adds what shades a ray in the draw that marches it.
void add_shade_of_ray(ShaderText& text, const scene::OneSurface& one, const PassPlan& plan) {
    if (!one.is_alone()) text.file("surfaces/way.glsl");
    add_picture(text, one, Draws::one);
    add_color(text, one);
    text.file("shade/lambert.glsl");
    add_gradient(text, plan);
    add_channels(text, one, plan.attachments, Draws::one);
    text.file("shade/shade.glsl");
}

// Begins with the field, of which marching takes these functions, and the ray.
ShaderText begin_fused(const scene::OneSurface& one, const PassPlan& plan,
                       std::vector<FieldFunction> functions) {
    ShaderText text;
    text.define(Feature::draws_at_once);
    if (!one.is_alone()) text.define(Feature::way_location, way_attachment(plan));
    define_state(text, plan);
    text.define(Feature::lights, int(one.scene.lights.size()));
    if (!plan.march_takes_gradient) functions.push_back(FieldFunction::gradient);
    add_field(text, *one.surface.field, through_copies(plan), functions,
              painting_functions(one, plan));
    add_ray(text, one);
    return text;
}

} // namespace

Pass fused_pass(const scene::OneSurface& one, const PassPlan& plan) {
    ShaderText text = begin_fused(one, plan, plan.samples);
    add_march(text, one, plan, Origin::eye, Draws::one);
    add_shade_of_ray(text, one, plan);
    if (!one.is_alone()) text.file("surfaces/nearest.glsl");
    text.file("shade/shade.frag");
    return std::move(text).pass(Role::fused, "fused", When::once_a_tile,
                                cover(one, Draws::one, plan.draws_squares));
}

Pass settled_pass(const scene::OneSurface& one, const PassPlan& plan) {
    ShaderText text = begin_fused(one, plan, {FieldFunction::directional});
    add_settled_march(text, plan);
    add_shade_of_ray(text, one, plan);
    text.file("shade/shade.frag");
    return std::move(text).pass(Role::settled, "settled", When::once_a_tile,
                                cover(one, Draws::one, plan.draws_squares));
}

Pass mask_pass(const scene::OneSurface& one, const PassPlan& plan) {
    ShaderText text;
    const bool by_beams = !plan.beams.empty();
    if (by_beams && one.is_alone()) {
        define_blocks(text, plan.beams.back());
        text.define(Feature::masks_blocks);
        text.file("march/mask.frag");
    } else {
        text.define(Feature::draws_at_once);
        text.file("math/bits.glsl");
        add_ray(text, one);
        add_ways(text, one, Origin::eye);
        add_way(text, plan, by_beams);
        text.file("march/mask.frag");
    }
    return std::move(text).pass(Role::mask, "mask", When::once_a_tile);
}

Pass surface_pass(const scene::OneSurface& one, const PassPlan& plan, Origin origin, When when) {
    ShaderText text;
    const bool begins_rays = one.is_alone() || sees_from_surfaces(one);
    std::vector<FieldFunction> functions;
    if (begins_rays) functions.push_back(FieldFunction::value);
    if (!plan.march_takes_gradient) functions.push_back(FieldFunction::gradient);
    add_field(text, *one.surface.field, plan, functions);
    if (!begins_rays)
        text.generated("no ray begins here, so how far off doesn't matter",
                       "float field(vec3 p) {\n    return 1.0;\n}\n");
    add_ray(text, one, origin);
    const bool by_lists = origin == Origin::eye && has_lists(plan);
    if (by_lists) {
        text.define(Feature::lists);
        add_entrance(text, plan, true);
    }
    if (origin != Origin::mirror) text.file("effects/surface_point.glsl"); // it has that already
    add_gradient(text, plan);
    if (!one.scene.sections.empty()) text.file("section/distance.glsl");
    // Among several surfaces the first one's rays meet the ground for all.
    const bool meets_ground = one.scene.ground && one.index == 0;
    if (meets_ground) text.define(Feature::meets_ground);
    text.file("effects/end_of_ray.glsl");
    text.file("effects/store_surface.glsl");
    if (!one.is_alone()) add_store_nearest(text, one, origin);
    const bool begins_paths = follows_paths(one.scene) && origin == Origin::eye;
    if (begins_paths) add_begin_of_path(text, one);
    const bool ends_at_bounds = origin == Origin::glass && !one.is_alone() && has_glass(one);
    if (ends_at_bounds) add_end_at_bounds(text);
    text.generated("generated: the first of what there is",
                   fmt::format("void main() {{\n    Ray ray = pixel_ray();\n"
                               "    RayState s = load_state();\n{}"
                               "    SurfacePoint p = end_of_ray(ray, s);\n{}{}"
                               "    {};\n{}}}\n",
                               by_lists ? "    Ray in_beam = ray;\n    enter_beam(in_beam);\n"
                                          "    choose_list(s.low);\n"
                                        : "",
                               !meets_ground ? ""
                               : origin == Origin::eye
                                   ? "    p = before_ground(ray, p, eye_begin(ray));\n"
                                   : "    p = before_ground(ray, p, 0.0);\n",
                               ends_at_bounds ? "    p = or_at_bounds(ray, p);\n" : "",
                               !one.is_alone() ? "store_nearest(ray, p, s.evaluations)"
                                               : "store_surface(p, s.evaluations)",
                               begins_paths ? "    store_begin(ray, begin_before());\n" : ""));
    switch (origin) {
    case Origin::mirror:
        return std::move(text).pass(Role::mirror_surface, "mirror surface", when);
    case Origin::glass:
        return std::move(text).pass(Role::glass_end, "glass end", when, cover_of_paths(one.scene));
    case Origin::eye:
        break;
    }
    return std::move(text).pass(Role::surface, "surface", when);
}

ShaderText begin_seen(const scene::OneSurface& one, const PassPlan& plan) {
    ShaderText text;
    text.define(Feature::lights, int(one.scene.lights.size()));
    std::vector<FieldFunction> functions;
    const bool paint = painting(one) != nullptr;
    if (paint && !plan.march_takes_gradient) functions.push_back(FieldFunction::gradient);
    if (paint || one.surface.material.contours) {
        add_field(text, *one.surface.field, plan, functions, painting_functions(one, plan));
    } else {
        text.file("math/bits.glsl");
    }
    add_ray(text, one);
    add_picture(text, one);
    add_color(text, one);
    text.file("effects/surface_point.glsl");
    return text;
}

Pass seen_pass(const scene::OneSurface& one, const PassPlan& plan) {
    ShaderText text = begin_seen(one, plan);
    add_load_surface(text, one);
    text.file("effects/load_mirrored.glsl");
    add_seen_shading(text, one);
    if (painting(one)) add_gradient(text, plan);
    text.file("surfaces/seen.frag");
    return std::move(text).pass(Role::seen, "seen", When::once_a_tile);
}

Pass shade_pass(const scene::OneSurface& one, const PassPlan& plan, When when) {
    ShaderText text;
    text.define(Feature::lights, int(one.scene.lights.size()));
    if (follows_paths(one.scene)) text.define(Feature::follows_paths);
    if (has_glass(one)) text.define(Feature::glass);
    const bool from_surface = keeps_surfaces(one);
    const formula::Field& field = *one.surface.field;
    const bool paint = painting(one) != nullptr;
    std::vector<FieldFunction> functions;
    // Paint may ask for the gradient too.
    const bool needs_gradient = !from_surface || paint;
    if (!plan.march_takes_gradient && needs_gradient) {
        functions.push_back(FieldFunction::gradient);
    }
    if (from_surface && one.scene.occlusion && one.is_alone())
        functions.push_back(FieldFunction::value);
    std::vector<GeneratedFunction> beside = painting_functions(one, plan);
    const bool paints_curvature = paint && painting(one)->hessian;
    if (const auto hessian = mirror_hessian(one); hessian && !paints_curvature) {
        beside.insert(beside.begin(), {"second derivatives", formula::kernels_used(*hessian),
                                       formula::glsl_hessian(*hessian, field.packing)});
    }
    if (!functions.empty() || !beside.empty()) {
        add_field(text, field, plan, functions, beside);
    } else {
        text.file("math/bits.glsl");
    }
    add_ray(text, one);
    add_picture(text, one);
    add_color(text, one);
    if (from_surface) {
        text.file("effects/surface_point.glsl");
        text.file("effects/load_surface.glsl");
    }
    if (calls_for_ends(one)) {
        add_shading(text, one);
    } else {
        if (!one.is_alone()) {
            add_sky(text, one.scene);
        }
        text.file("shade/lambert.glsl");
    }
    if (needs_gradient) add_gradient(text, plan);
    if (!one.is_alone()) {
        text.generated("generated: which surface is seen",
                       "uniform sampler2D surface_texture_3;\n");
    }
    add_channels(text, one, plan.attachments);
    if (!from_surface) text.file("shade/shade.glsl");
    text.file(from_surface ? "effects/shade.frag" : "shade/shade.frag");
    return std::move(text).pass(Role::shade, "shade", when, cover(one, Draws::several));
}

Pass motion_pass(const scene::OneSurface& one, const PassPlan& plan) {
    ShaderText text;
    add_field(text, *one.surface.field, plan, {FieldFunction::value, FieldFunction::gradient});
    add_ray(text, one);
    text.file("effects/motion.frag");
    return std::move(text).pass(Role::motion, "motion", When::at_two_times);
}

} // namespace isomotion::shader
