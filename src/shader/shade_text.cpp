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

struct ChannelShader {
    Channel channel;
    const char* file;
    const char* function;
    Feature location;
    const char* output;
};

constexpr ChannelShader channel_shaders[] = {
    {Channel::depth, "channels/depth.glsl", "write_depth", Feature::depth_location, "depth_out"},
    {Channel::normal, "channels/normal.glsl", "write_normal", Feature::normal_location,
     "normal_out"},
    {Channel::position, "channels/position.glsl", "write_position", Feature::position_location,
     "position_out"},
    {Channel::cap, "channels/cap.glsl", "write_cap", Feature::cap_location, "cap_out"},
    {Channel::surface, "channels/surface.glsl", "write_surface", Feature::surface_location,
     "surface_out"},
    {Channel::ending, "channels/ending.glsl", "write_ending", Feature::ending_location,
     "ending_out"},
};

// write_channels(), to the attachments from the third on. Surfaces that draw over each other have
// keep_channels() beside it.
void add_channels(ShaderText& text, const scene::OneSurface& one,
                  const std::vector<Channel>& written, Draws draws = Draws::several) {
    const bool over_others = !one.is_alone() && draws == Draws::one;
    std::string calls, samplers, kept;
    int location = 2;
    for (const ChannelShader& shader : channel_shaders) {
        if (!contains(written, shader.channel)) continue;
        text.define(shader.location, location);
        const bool lacks_caps = shader.channel == Channel::cap && one.scene.sections.empty();
        if (shader.channel == Channel::surface) text.define(Feature::surface_number, one.index + 1);
        if (shader.channel == Channel::ending && !one.is_alone()) {
            if (over_others) text.file("surfaces/eye_way.glsl");
            text.file(over_others ? "surfaces/own_ending.glsl" : "surfaces/ending.glsl");
        } else {
            text.file(lacks_caps ? "channels/no_cap.glsl" : shader.file);
        }
        calls += fmt::format("    {}(ray, hit, verdict);\n", shader.function);
        samplers += fmt::format("uniform sampler2D before_texture_{};\n", location);
        kept += fmt::format("    {} = texelFetch(before_texture_{}, at, 0){};\n", shader.output,
                            location, shader.channel == Channel::ending ? ".x" : "");
        ++location;
    }
    text.generated("generated: the channels asked for",
                   "void write_channels(Ray ray, Hit hit, int verdict) {\n" + calls + "}\n");
    if (over_others && one.index != 0)
        text.generated("generated: the same of the surfaces before",
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

void add_matter_color(ShaderText& text, const scene::OneSurface& one) {
    if (painting(one)) {
        add_painting(text, one);
    } else {
        text.file(one.surface.material.inside ? "shade/two_sided.glsl" : "shade/one_sided.glsl");
    }
}

// Whether rays or samples begin where others ended.
bool sees_from_surfaces(const scene::OneSurface& one) {
    return shadow_mask(one.scene) != 0 || has_mirrored_rays(one) || follows_paths(one.scene) ||
           one.scene.occlusion;
}

} // namespace

void add_gradient(ShaderText& text, const scene::OneSurface& one, const Passes& passes) {
    add_gradient_of_rest(text, one.scene,
                         passes.march_takes_gradient ? "shade/gradient_from_state.glsl"
                                                     : "shade/gradient_from_field.glsl");
}

void add_color(ShaderText& text, const scene::OneSurface& one) {
    std::vector<std::string> over;
    if (has_cap_color(one)) over.emplace_back("section/color.glsl");
    if (one.surface.material.contours) over.emplace_back("effects/contours.glsl");
    for (std::size_t k = 0; k <= over.size(); ++k) {
        const bool is_last = k == over.size();
        std::string names = k == 0 ? "" : fmt::format("#define color_below color_{}\n", k - 1);
        if (!is_last) names += fmt::format("#define surface_color color_{}\n", k);
        if (!names.empty()) text.generated("one colour over another", names);
        if (k == 0) {
            add_matter_color(text, one);
        } else {
            text.file(over[k - 1]);
        }
        if (!is_last)
            text.generated("by the names of the next",
                           "#undef surface_color\n#undef color_below\n");
    }
}

void add_picture(ShaderText& text, const scene::OneSurface& one, Draws draws) {
    text.file(has_flat_shading(one, draws) ? "shade/shading_flat.glsl" : "shade/shading.glsl");
    text.file("shade/hit.glsl");
    text.file("shade/record.glsl");
}

std::vector<Channel> written_channels(const std::vector<Channel>& channels) {
    std::vector<Channel> written;
    for (const ChannelShader& shader : channel_shaders) {
        if (contains(channels, shader.channel)) written.push_back(shader.channel);
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
void add_shade_of_ray(ShaderText& text, const scene::OneSurface& one, const Passes& passes) {
    add_picture(text, one, Draws::one);
    add_color(text, one);
    text.file("shade/lambert.glsl");
    add_gradient(text, one, passes);
    add_channels(text, one, passes.attachments, Draws::one);
    text.file("shade/shade.glsl");
}

// Begins with the field, of which marching takes these functions, and the ray.
ShaderText begin_fused(const scene::OneSurface& one, const Passes& passes,
                       std::vector<FieldFunction> functions) {
    ShaderText text;
    define_state(text, passes);
    text.define(Feature::lights, int(one.scene.lights.size()));
    if (!passes.march_takes_gradient) functions.push_back(FieldFunction::gradient);
    add_field(text, *one.surface.field, through_copies(passes), functions,
              painting_functions(one, passes));
    add_ray(text, one);
    return text;
}

} // namespace

Pass fused_pass(const scene::OneSurface& one, const Passes& passes) {
    ShaderText text = begin_fused(one, passes, passes.samples);
    add_march(text, one, passes, Origin::eye, Draws::one);
    add_shade_of_ray(text, one, passes);
    if (!one.is_alone()) {
        add_keep_nearest(text, one, passes);
        text.file("surfaces/fused.frag");
    } else {
        text.file("shade/fused.frag");
    }
    return std::move(text).pass(Role::fused, "fused", When::once_a_tile,
                                cover(one, Draws::one, passes.draws_squares));
}

Pass settled_pass(const scene::OneSurface& one, const Passes& passes) {
    ShaderText text = begin_fused(one, passes, {FieldFunction::directional});
    add_settled_march(text, passes);
    add_shade_of_ray(text, one, passes);
    text.file("shade/settled.frag");
    return std::move(text).pass(Role::settled, "settled", When::once_a_tile,
                                cover(one, Draws::one, passes.draws_squares));
}

Pass mask_pass(const scene::OneSurface& one, const Passes& passes) {
    ShaderText text;
    const bool by_beams = !passes.beams.empty();
    if (by_beams && one.is_alone()) {
        define_blocks(text, passes.beams.back());
        text.file("march/mask_of_blocks.frag");
    } else {
        text.file("math/bits.glsl");
        add_ray(text, one);
        begin_entrance(text, one, Origin::eye);
        add_way(text, passes, by_beams);
        end_entrance(text, one, Origin::eye, Draws::one);
        text.file("march/mask.frag");
    }
    return std::move(text).pass(Role::mask, "mask", When::once_a_tile);
}

Pass surface_pass(const scene::OneSurface& one, const Passes& passes, Origin origin, When when) {
    ShaderText text;
    const bool begins_rays = one.is_alone() || sees_from_surfaces(one);
    std::vector<FieldFunction> functions;
    if (begins_rays) functions.push_back(FieldFunction::value);
    if (!passes.march_takes_gradient) functions.push_back(FieldFunction::gradient);
    add_field(text, *one.surface.field, passes, functions);
    if (!begins_rays)
        text.generated("no ray begins here, so how far off doesn't matter",
                       "float field(vec3 p) {\n    return 1.0;\n}\n");
    add_ray(text, one, origin);
    const bool by_lists = origin == Origin::eye && has_lists(passes);
    if (by_lists) {
        text.define(Feature::lists);
        add_entrance(text, passes, true);
    }
    if (origin == Origin::eye) text.file("effects/eye_begin.glsl");
    if (origin != Origin::mirror) text.file("effects/surface_point.glsl"); // it has that already
    add_gradient(text, one, passes);
    if (!one.scene.sections.empty()) text.file("section/distance.glsl");
    text.file("effects/end_of_ray.glsl");
    text.file("effects/store_surface.glsl");
    if (!one.is_alone()) add_store_nearest(text, one, origin);
    const bool begins_paths = follows_paths(one.scene) && origin == Origin::eye;
    if (begins_paths) add_begin_of_path(text, one);
    const bool ends_at_bounds = origin == Origin::glass && !one.is_alone() && has_glass(one);
    if (ends_at_bounds) add_end_at_bounds(text);
    // Among several surfaces the first one's rays meet the ground for all.
    const bool meets_ground = one.scene.ground && one.index == 0;
    if (meets_ground) text.file("effects/ground.glsl");
    text.generated("generated: the first of what there is",
                   fmt::format("void main() {{\n    Ray ray = pixel_ray();\n"
                               "    RayState s = load_state();\n{}"
                               "    SurfacePoint p = end_of_ray(ray, s);\n{}{}"
                               "    {};\n{}}}\n",
                               by_lists ? "    Ray in_beam = ray;\n    enter_beam(in_beam);\n"
                                          "    choose_list(s.low);\n"
                                        : "",
                               meets_ground ? "    p = before_ground(ray, p);\n" : "",
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

ShaderText begin_seen(const scene::OneSurface& one, const Passes& passes) {
    ShaderText text;
    text.define(Feature::lights, int(one.scene.lights.size()));
    std::vector<FieldFunction> functions;
    const bool paint = painting(one) != nullptr;
    if (paint && !passes.march_takes_gradient) functions.push_back(FieldFunction::gradient);
    if (paint || one.surface.material.contours) {
        add_field(text, *one.surface.field, passes, functions, painting_functions(one, passes));
    } else {
        text.file("math/bits.glsl");
    }
    add_ray(text, one);
    add_picture(text, one);
    add_color(text, one);
    text.file("effects/eye_begin.glsl");
    text.file("effects/surface_point.glsl");
    return text;
}

Pass seen_pass(const scene::OneSurface& one, const Passes& passes) {
    ShaderText text = begin_seen(one, passes);
    add_load_surface(text, one);
    text.file("effects/load_mirrored.glsl");
    add_seen_shading(text, one);
    if (painting(one)) add_gradient(text, one, passes);
    text.define(Feature::surface, one.index);
    text.file("surfaces/seen.frag");
    return std::move(text).pass(Role::seen, "seen", When::once_a_tile);
}

Pass shade_pass(const scene::OneSurface& one, const Passes& passes, When when) {
    ShaderText text;
    text.define(Feature::lights, int(one.scene.lights.size()));
    const bool from_surface = keeps_surfaces(one);
    const formula::Field& field = *one.surface.field;
    const bool paint = painting(one) != nullptr;
    std::vector<FieldFunction> functions;
    // Paint may ask for the gradient too.
    const bool needs_gradient = !from_surface || paint;
    if (!passes.march_takes_gradient && needs_gradient) {
        functions.push_back(FieldFunction::gradient);
    }
    if (from_surface && one.scene.occlusion && one.is_alone())
        functions.push_back(FieldFunction::value);
    std::vector<GeneratedFunction> beside = painting_functions(one, passes);
    const bool paints_curvature = paint && painting(one)->hessian;
    if (const auto hessian = mirror_hessian(one); hessian && !paints_curvature) {
        beside.insert(beside.begin(), {"second derivatives", formula::kernels_used(*hessian),
                                       formula::glsl_hessian(*hessian, field.packing)});
    }
    if (!functions.empty() || !beside.empty()) {
        add_field(text, field, passes, functions, beside);
    } else {
        text.file("math/bits.glsl");
    }
    add_ray(text, one);
    add_picture(text, one);
    add_color(text, one);
    if (from_surface) {
        text.file("effects/eye_begin.glsl");
        text.file("effects/surface_point.glsl");
        text.file("effects/load_surface.glsl");
    }
    if (calls_for_ends(one)) {
        add_shading(text, one);
    } else {
        text.file("shade/lambert.glsl");
        if (!one.is_alone()) {
            text.file("effects/hit_of.glsl");
            text.file(sky_file(one.scene));
            text.file("surfaces/plain.glsl");
        }
    }
    if (needs_gradient) add_gradient(text, one, passes);
    if (!one.is_alone()) {
        text.define(Feature::surface, one.index);
        text.generated("generated: which surface is seen",
                       "uniform sampler2D surface_texture_3;\n");
    }
    add_channels(text, one, passes.attachments);
    if (!from_surface) text.file("shade/shade.glsl");
    text.file(follows_paths(one.scene) ? "paths/shade.frag"
              : !one.is_alone()        ? "surfaces/shade.frag"
              : has_glass(one)         ? "glass/shade.frag"
              : from_surface           ? "effects/shade.frag"
                                       : "shade/shade.frag");
    return std::move(text).pass(Role::shade, "shade", when, cover(one, Draws::several));
}

Pass motion_pass(const scene::OneSurface& one, const Passes& passes) {
    ShaderText text;
    add_field(text, *one.surface.field, passes, {FieldFunction::value, FieldFunction::gradient});
    add_ray(text, one);
    text.file("effects/motion.frag");
    return std::move(text).pass(Role::motion, "motion", When::at_two_times);
}

} // namespace isomotion::shader
