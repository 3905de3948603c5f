#include "shader/march_text.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "shader/beam_copies_text.h"
#include "shader/beam_text.h"
#include "shader/cells_text.h"
#include "shader/effect_text.h"
#include "shader/glass_text.h"
#include "shader/loop_limit.h"
#include "shader/paths_text.h"
#include "shader/section_text.h"
#include "shader/surfaces_text.h"
#include "shader/tape_text.h"

namespace isomotion::shader {
namespace {

void add_files(ShaderText& text, std::span<const std::string_view> names) {
    for (const std::string_view name : names) {
        if (!name.empty()) text.file(fmt::format("march/{}.glsl", name));
    }
}

// Whether cubics have to look out for places where F isn't smooth.
bool meets_rough_places(const scene::OneSurface& one) {
    return one.surface.isolation.method == scene::Method::hermite &&
           !one.surface.measured.smoothness.is_smooth();
}

// Whether bounds of F judge where cubics take it for 0 without a change of sign. Where F isn't
// smooth, rough.glsl does that.
bool judges_touches(const scene::OneSurface& one) {
    return one.surface.isolation.method == scene::Method::hermite &&
           one.surface.measured.smoothness.false_touches && !meets_rough_places(one);
}

// The boxes in which bounds look whether F touches 0: as many as a third of a draw's loops may run
// tapes for (render/scene_plan.cpp).
int tries_of_a_touch(const Passes& passes) {
    constexpr double most = 64, third = loop_iterations_per_pass / 3;
    if (!passes.tapes) return int(most);
    const double each = passes.tapes->cost({FieldFunction::value_interval}).iterations;
    return int(std::clamp(third / each, 1.0, most));
}

// The paper's methods go all the way, as the paper has them.
bool passes_free_cells(const scene::OneSurface& one, const Passes& passes) {
    return (array_with_grid(passes) || (passes.tapes && passes.tapes->chooses())) &&
           scene::traits(one.surface.isolation.method).steps == scene::Steps::cubics;
}

void add_way_past(ShaderText& text, const Passes& passes) {
    if (passes.tapes)
        add_way_past_free_tapes(text);
    else
        add_way_past_free_cells(text);
}

// What finds a root between two samples, or in a piece.
void add_isolation(ShaderText& text, const scene::OneSurface& one, const Passes& passes) {
    const scene::MethodTraits& method = scene::traits(one.surface.isolation.method);
    const bool directional = passes.samples.front() == FieldFunction::directional;
    const bool bounds = method.samples == scene::Samples::value_and_bounds;
    const bool is_rough = meets_rough_places(one);
    if (bounds) text.define(Feature::bounds_pieces);
    if (bounds || is_rough || judges_touches(one)) text.file("march/piece_box.glsl");
    if (bounds || is_rough) text.file("march/piece_bounds.glsl");
    if (!bounds) {
        if (passes.tapes && is_rough) add_signs_in_free_tapes(text, *passes.tapes);
        text.file(directional ? "march/sample_directional.glsl" : "march/sample_value.glsl");
    }
    add_files(text, method.test);
}

// turn(), which takes a ray on by what one sample of the field tells.
void add_turn(ShaderText& text, const scene::OneSurface& one, const Passes& passes) {
    const scene::MethodTraits& method = scene::traits(one.surface.isolation.method);
    const bool is_rough = meets_rough_places(one);
    if (method.samples == scene::Samples::value_and_bounds || is_rough) {
        text.file("march/finest.glsl");
        if (!is_rough) text.file("march/refine.glsl");
        const bool breaks = passes.samples.back() == FieldFunction::breaks;
        if (breaks && one.surface.jumps_are_walls) text.define(Feature::walls);
        text.file(breaks ? "march/breaks.glsl" : "march/no_breaks.glsl");
        text.file(is_rough ? "march/rough.glsl" : "march/touches.glsl");
    }
    if (is_rough) text.define(Feature::rough);
    if (passes.branches && method.steps == scene::Steps::cubics) text.define(Feature::branches);
    if (judges_touches(one)) {
        text.define(Feature::most_tries, tries_of_a_touch(passes));
        text.file("march/touch_by_bounds.glsl");
        text.define(Feature::bounded_touches);
        text.define(Feature::solves);
    }
    add_files(text, method.turn);
}

} // namespace

std::vector<FieldFunction> samples_of(const scene::OneSurface& one, bool march_takes_gradient) {
    const scene::MethodTraits& method = scene::traits(one.surface.isolation.method);
    const auto with_breaks = [&](std::vector<FieldFunction> functions) {
        const formula::Smoothness& is = one.surface.measured.smoothness;
        if (is.jumps || is.poles) functions.push_back(FieldFunction::breaks);
        return functions;
    };
    if (method.samples == scene::Samples::value_and_bounds)
        return with_breaks({FieldFunction::value, FieldFunction::directional_interval});
    if (meets_rough_places(one))
        return with_breaks({FieldFunction::directional, FieldFunction::rough,
                            FieldFunction::directional_interval});
    if (judges_touches(one)) return {FieldFunction::directional, FieldFunction::value_interval};
    const bool value_is_enough = method.samples == scene::Samples::value && !march_takes_gradient;
    return {value_is_enough ? FieldFunction::value : FieldFunction::directional};
}

void add_ray(ShaderText& text, const scene::OneSurface& one, Origin origin) {
    if (!one.is_alone()) text.define(Feature::surface, int(one.index));
    add_sections(text, one.scene);
    text.file_of_stage("frame.glsl", "stage/frame.glsl");
    text.file("march/verdict.glsl");
    define_bounds(text, one);
    switch (origin) {
    case Origin::eye:
        text.define(Feature::eye_rays);
        break;
    case Origin::mirror:
        text.define(Feature::mirrored_rays);
        break;
    case Origin::glass:
        text.define(Feature::path_rays);
        break;
    }
    text.file("march/ray.glsl");
    if (origin == Origin::glass && follows_paths(one.scene)) {
        add_path_ray(text, one);
    } else if (origin == Origin::glass) {
        add_glass_ray(text);
    }
    if (origin == Origin::mirror) {
        text.file("effects/surface_point.glsl");
        add_load_surface(text, one);
        add_mirror_ray(text, one);
    }
    text.file("march/state.glsl");
    add_parts(text, one.scene);
}

void define_bounds(ShaderText& text, const scene::OneSurface& one) {
    if (one.surface.bounds.shape == scene::Bounds::Shape::box) text.define(Feature::box);
}

void define_state(ShaderText& text, const Passes& passes) {
    if (passes.state_textures == 3) text.define(Feature::three_samples);
}

// Whether the first sample of a march tells the sign of F where the ray begins, and the last one
// where it leaves: then caps take no sample of their own. Breaks and free cells leave other values
// in a ray's state.
bool samples_tell_caps(const scene::OneSurface& one, const Passes& passes) {
    const scene::MethodTraits& method = scene::traits(one.surface.isolation.method);
    if (passes_free_cells(one, passes)) return false;
    if (method.samples == scene::Samples::value_and_bounds)
        return passes.samples.back() != FieldFunction::breaks;
    return method.steps == scene::Steps::cubics && !meets_rough_places(one);
}

void add_march(ShaderText& text, const scene::OneSurface& one, const Passes& passes, Origin origin,
               Draws draws) {
    const bool beam = !passes.beams.empty() && origin == Origin::eye;
    if (beam && has_lists(passes)) text.define(Feature::lists);
    add_ways(text, one, origin);
    add_entrance(text, passes, beam);
    add_isolation(text, one, passes);
    text.file(passes.march_takes_gradient ? "march/gradient_at_root.glsl"
                                          : "march/end_at_root.glsl");
    if (beam && settles_blocks(passes) && draws == Draws::several) {
        text.define(Feature::settles);
        add_files(text,
                  std::array<std::string_view, 4>{"beam_roots", "slab", "begin_in_slab", "newton"});
    }
    add_turn(text, one, passes);
    if (array_with_grid(passes)) text.define(Feature::grid);
    if (passes_free_cells(one, passes)) add_way_past(text, passes);
    add_march_of_parts(text, one, samples_tell_caps(one, passes));
}

void add_settled_march(ShaderText& text, const Passes& passes) {
    define_blocks(text, passes.beams.back());
    add_files(text, std::array<std::string_view, 9>{
                        "beam_roots", "slab", "begin_in_slab", "sample_directional",
                        passes.march_takes_gradient ? "gradient_at_root" : "end_at_root", "newton",
                        "settled", "turn_point", "march"});
}

Pass march_pass(const scene::OneSurface& one, const Passes& passes, Origin origin, When when) {
    ShaderText text(passes.stage);
    define_state(text, passes);
    add_field(text, *one.surface.field, through_copies(passes), passes.samples);
    add_ray(text, one, origin);
    add_march(text, one, passes, origin);
    text.file_of_stage("march/store_state.glsl", "stage/store_state.glsl");
    text.file("march/march_pixel.glsl");
    text.file_of_stage("stage/march.frag", "stage/march.comp");
    switch (origin) {
    case Origin::mirror:
        return std::move(text).pass(Role::mirror, "mirror", when);
    case Origin::glass:
        return std::move(text).pass(Role::glass, "glass", when, cover_of_paths(one.scene));
    case Origin::eye:
        break;
    }
    return std::move(text).pass(Role::march, "march", when);
}

Pass active_pass(When when) {
    ShaderText text;
    text.file("march/state.glsl");
    text.file("march/active.frag");
    return std::move(text).pass(Role::active, "active", when);
}

Pass shadow_pass(const scene::OneSurface& one, const Passes& passes) {
    const scene::MethodTraits& method = scene::traits(one.surface.isolation.method);
    ShaderText text(passes.stage);
    define_state(text, passes);
    text.define(Feature::lights, int(one.scene.lights.size()));
    text.define(Feature::shadows, shadow_mask(one.scene));
    if (passes.light_beams != 0) {
        text.define(Feature::light_beams, passes.light_beams);
        if (has_lists(passes)) text.define(Feature::lists);
    }
    add_field(text, *one.surface.field, passes, passes.samples);
    add_ray(text, one);
    add_isolation(text, one, passes);
    text.file_of_stage("march/store_state.glsl", "stage/store_state.glsl");
    text.file("shade/shading.glsl");
    text.file("shade/hit.glsl");
    add_lights(text, one.scene);
    text.file("effects/surface_point.glsl");
    add_load_surface(text, one);
    if (passes.light_beams != 0) add_light_beams(text, passes);
    if (method.any_hit_turns) {
        text.file("march/end_at_root.glsl");
        add_turn(text, one, passes);
    }
    if (array_with_grid(passes)) text.define(Feature::grid);
    if (passes_free_cells(one, passes)) add_way_past(text, passes);
    text.file(fmt::format("march/{}.glsl", method.any_hit));
    add_crossings(text, one);
    text.file("effects/shadow.glsl");
    text.file_of_stage("stage/march.frag", "stage/march.comp");
    return std::move(text).pass(Role::shadow, "shadow", When::until_rays_end);
}

} // namespace isomotion::shader
