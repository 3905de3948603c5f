#include "shader/march_text.h"

#include <algorithm>

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
int tries_of_a_touch(const PassPlan& plan) {
    constexpr double most = 64, third = loop_iterations_per_pass / 3;
    if (!plan.tapes) return int(most);
    const double each = plan.tapes->cost({FieldFunction::value_interval}).iterations;
    return int(std::clamp(third / each, 1.0, most));
}

// The paper's methods go all the way, as the paper has them.
bool passes_free_cells(const scene::OneSurface& one, const PassPlan& plan) {
    return (array_with_grid(plan) || (plan.tapes && plan.tapes->chooses())) &&
           scene::traits(one.surface.isolation.method).steps == scene::Steps::cubics;
}

// Lets rays skip cells without roots.
void add_way_past(ShaderText& text) {
    text.define(Feature::passes_free);
    text.file("march/free_cells.glsl");
}

// What finds a root between two samples, or in a piece.
void add_isolation(ShaderText& text, const scene::OneSurface& one, const PassPlan& plan) {
    const scene::MethodTraits& method = scene::traits(one.surface.isolation.method);
    const bool directional = plan.samples.front() == FieldFunction::directional;
    const bool bounds = method.samples == scene::Samples::value_and_bounds;
    const bool is_rough = meets_rough_places(one);
    if (bounds) text.define(Feature::bounds_pieces);
    if (is_rough) text.define(Feature::rough);
    if (bounds || is_rough || judges_touches(one)) text.file("march/pieces.glsl");
    if (!bounds) {
        if (directional) text.define(Feature::samples_slope);
        if (plan.tapes && is_rough) define_signs_in_free_tapes(text, *plan.tapes);
        text.file("march/sample.glsl");
    }
    if (method.steps != scene::Steps::scene_step) return;
    text.define(Feature::scene_steps);
    if (method.method != scene::Method::marching) text.define(Feature::adaptive_steps);
    if (method.method == scene::Method::amp_taylor) text.define(Feature::taylor_test);
    text.file("march/amp_steps.glsl");
}

// turn(), which takes a ray on by what one sample of the field tells.
void add_turn(ShaderText& text, const scene::OneSurface& one, const PassPlan& plan) {
    const scene::MethodTraits& method = scene::traits(one.surface.isolation.method);
    const bool is_rough = meets_rough_places(one);
    if (method.samples == scene::Samples::value_and_bounds || is_rough) {
        const bool breaks = plan.samples.back() == FieldFunction::breaks;
        if (breaks) text.define(Feature::breaks);
        text.file("march/refine.glsl");
        if (breaks && one.surface.jumps_are_walls) text.define(Feature::walls);
        text.file(is_rough ? "march/rough.glsl" : "march/touches.glsl");
    }
    if (plan.branches && method.steps == scene::Steps::cubics) text.define(Feature::branches);
    if (judges_touches(one)) {
        text.define(Feature::most_tries, tries_of_a_touch(plan));
        text.file("march/touch_by_bounds.glsl");
        text.define(Feature::bounded_touches);
        text.define(Feature::solves);
    }
    switch (method.steps) {
    case scene::Steps::scene_step:
        text.file("march/amp.glsl");
        break;
    case scene::Steps::cubics:
        text.file("march/cubic.glsl");
        break;
    case scene::Steps::bounds:
        text.file(fmt::format("march/{}.glsl", method.name));
        break;
    }
    text.file("march/turn.glsl");
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
    text.file("frame.glsl");
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

void define_state(ShaderText& text, const PassPlan& plan) {
    if (plan.state_textures == 3) text.define(Feature::three_samples);
}

// Whether the first sample of a march tells the sign of F where the ray begins, and the last one
// where it leaves: then caps take no sample of their own. Breaks and free cells leave other values
// in a ray's state.
bool samples_tell_caps(const scene::OneSurface& one, const PassPlan& plan) {
    const scene::MethodTraits& method = scene::traits(one.surface.isolation.method);
    if (passes_free_cells(one, plan)) return false;
    if (method.samples == scene::Samples::value_and_bounds)
        return plan.samples.back() != FieldFunction::breaks;
    return method.steps == scene::Steps::cubics && !meets_rough_places(one);
}

namespace {

void add_ends_at_roots(ShaderText& text, const PassPlan& plan) {
    if (plan.march_takes_gradient) text.define(Feature::march_takes_gradient);
    text.file("march/at_root.glsl");
}

} // namespace

void add_march(ShaderText& text, const scene::OneSurface& one, const PassPlan& plan, Origin origin,
               Draws draws) {
    const bool beam = !plan.beams.empty() && origin == Origin::eye;
    if (beam && has_lists(plan)) text.define(Feature::lists);
    add_ways(text, one, origin);
    add_entrance(text, plan, beam);
    add_isolation(text, one, plan);
    add_ends_at_roots(text, plan);
    if (beam && settles_blocks(plan) && draws == Draws::several) {
        text.define(Feature::settles);
        text.file("march/slab.glsl");
        text.file("march/settled.glsl");
    }
    add_turn(text, one, plan);
    if (array_with_grid(plan)) text.define(Feature::grid);
    if (passes_free_cells(one, plan)) add_way_past(text);
    add_march_of_parts(text, one, samples_tell_caps(one, plan));
}

void add_settled_march(ShaderText& text, const PassPlan& plan) {
    define_blocks(text, plan.beams.back());
    text.define(Feature::settled_rays);
    text.define(Feature::samples_slope);
    text.file("march/slab.glsl");
    text.file("march/sample.glsl");
    add_ends_at_roots(text, plan);
    text.file("march/settled.glsl");
    text.file("march/turn.glsl");
    text.file("march/march.glsl");
}

Pass march_pass(const scene::OneSurface& one, const PassPlan& plan, Origin origin, When when) {
    ShaderText text(plan.stage);
    define_state(text, plan);
    add_field(text, *one.surface.field, through_copies(plan), plan.samples);
    add_ray(text, one, origin);
    add_march(text, one, plan, origin);
    text.file("march/store_state.glsl");
    text.file("march/march_pixel.glsl");
    text.file("stage/main.glsl");
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
    text.define(Feature::counts_rays);
    text.file("march/mask.frag");
    return std::move(text).pass(Role::active, "active", when);
}

Pass shadow_pass(const scene::OneSurface& one, const PassPlan& plan) {
    const scene::MethodTraits& method = scene::traits(one.surface.isolation.method);
    ShaderText text(plan.stage);
    define_state(text, plan);
    text.define(Feature::lights, int(one.scene.lights.size()));
    text.define(Feature::shadows, shadow_mask(one.scene));
    if (plan.light_beams != 0) {
        text.define(Feature::light_beams, plan.light_beams);
        if (has_lists(plan)) text.define(Feature::lists);
    }
    add_field(text, *one.surface.field, plan, plan.samples);
    add_ray(text, one);
    add_isolation(text, one, plan);
    text.file("march/store_state.glsl");
    text.file("shade/shading.glsl");
    text.file("shade/hit.glsl");
    add_lights(text, one.scene);
    text.file("effects/surface_point.glsl");
    add_load_surface(text, one);
    if (plan.light_beams != 0) add_light_beams(text, plan);
    if (method.steps != scene::Steps::scene_step) {
        text.file("march/at_root.glsl");
        add_turn(text, one, plan);
    }
    if (array_with_grid(plan)) text.define(Feature::grid);
    if (passes_free_cells(one, plan)) add_way_past(text);
    text.file("march/any_hit.glsl");
    add_crossings(text, one);
    text.file("effects/shadow.glsl");
    text.file("stage/main.glsl");
    return std::move(text).pass(Role::shadow, "shadow", When::until_rays_end);
}

} // namespace isomotion::shader
