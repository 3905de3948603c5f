#include "shader/assemble.h"

#include <algorithm>
#include <memory>
#include <span>

#include "shader/beam_copies_text.h"
#include "shader/beam_text.h"
#include "shader/effect.h"
#include "shader/effect_text.h"
#include "shader/finding_elements.h"
#include "shader/glass_text.h"
#include "shader/inlined_size.h"
#include "shader/march_text.h"
#include "shader/paths_text.h"
#include "shader/proof_text.h"
#include "shader/shade_text.h"
#include "shader/surfaces_text.h"
#include "shader/tape_text.h"

namespace isomotion::shader {
namespace {

// The rest is the prelude's.
void become_glsl_es(Pass& pass) {
    for (std::string* text : {&pass.vertex, &pass.text})
        text->replace(0, text->find('\n'), "#version 300 es");
}

// Whether beams by intervals do. Compute shaders are for hardware with more lanes than a picture
// has blocks, where a walk along a beam takes longer than it saves, but for lists of elements.
bool pays_in(Stage stage, const scene::OneSurface& one, bool makes_lists) {
    return stage == Stage::fragment || makes_lists || one.surface.isolation.beam.value_or(false);
}

// From so many pixels on an H100 has enough blocks to settle (docs/performance.md).
constexpr std::int64_t fewest_to_settle = 2'000'000;

// Whether a gradient is so long that compiling it is felt: some 0.2 s on a software renderer,
// growing with its length.
bool is_long(const formula::Program& gradient) { return gradient.instructions.size() > 1000; }

std::vector<BeamLevel> beams_of(const scene::OneSurface& one, const FieldStorage& storage,
                                const Drawing& drawing) {
    const bool on_web = drawing.platform == Platform::webgl;
    std::vector<BeamLevel> beams;
    // A page's beams that keep no bits find elements by place as its rays do.
    if (uses_beams(one) && (on_web || !array_with_grid(storage)) &&
        pays_in(drawing.stage, one, has_lists(storage)))
        beams = beam_levels(storage, drawing.finest_beam);
    const bool settling_pays =
        drawing.pixels >= fewest_to_settle || pays_in(drawing.stage, one, false);
    if (!on_web && !storage.tapes && settling_pays && can_settle_blocks(one, drawing.finest_beam))
        beams.push_back(level_by_models(drawing.finest_beam));
    return beams;
}

std::vector<Channel> attachments_of(const scene::OneSurface& one, std::vector<Channel> wanted,
                                    const Drawing& drawing) {
    const bool certifies = one.surface.isolation.certify;
    if (certifies || drawing.tells_endings) wanted.push_back(Channel::ending);
    if (certifies && !one.is_alone()) wanted.push_back(Channel::surface);
    return written_channels(wanted);
}

// What is decided before any text: with these tapes for the field, or the field's own code.
PassPlan plan_with(const std::shared_ptr<const FieldTapes>& tapes, const scene::OneSurface& one,
                   const std::vector<Channel>& channels, const Drawing& drawing,
                   bool keeps_copies) {
    const bool on_web = drawing.platform == Platform::webgl;
    FieldStorage storage =
        tapes ? storage_of_all_elements(one) : storage_of_elements(one, drawing, keeps_copies);
    storage.tapes = tapes;
    const std::vector<BeamLevel> beams = beams_of(one, storage, drawing);
    // A wall's normal is no slope along a ray.
    const bool march_takes_gradient =
        !tapes && is_long(one.surface.field->gradient) && !one.surface.jumps_are_walls;
    const std::vector<Channel> attachments = attachments_of(one, channels, drawing);
    const bool fuses =
        drawing.stage == Stage::fragment && can_fuse(one, channels, int(attachments.size()));
    return {storage,
            beams,
            fuses,
            fuses && one.is_alone() && !on_web,
            beams.empty() || on_web ? 0 : shadow_mask(one.scene) & far_lights(one.scene),
            drawing.stage,
            drawing.branches,
            scene::traits(one.surface.isolation.method).state_textures,
            samples_of(one, march_takes_gradient),
            march_takes_gradient,
            attachments};
}

// Copies are kept where they fit.
PassPlan plan_of(const std::shared_ptr<const FieldTapes>& tapes, const scene::OneSurface& one,
                 const std::vector<Channel>& channels, const Drawing& drawing) {
    PassPlan plan = plan_with(tapes, one, channels, drawing, true);
    if (!has_copies(plan) || copies_fit(plan)) return plan;
    return plan_with(tapes, one, channels, drawing, false);
}

// The passes of a plan, in the order of a frame.
std::vector<Pass> passes_of(const scene::OneSurface& one, const PassPlan& plan,
                            const std::vector<Channel>& channels, bool on_web) {
    std::vector<Pass> list;
    const auto add = [&](Pass pass) { list.push_back(std::move(pass)); };
    const auto add_all = [&](std::vector<Pass> passes) {
        for (Pass& pass : passes) add(std::move(pass));
    };
    for (int level = 0; level < int(plan.beams.size()); ++level) {
        add(beam_pass(one, plan, level));
        if (has_copies(plan)) add(beam_copies_pass(one, plan, level));
    }
    if (plan.fuses) {
        if (!plan.draws_squares) add(mask_pass(one, plan));
        if (settles_blocks(plan)) add(settled_pass(one, plan));
        add(fused_pass(one, plan));
    }
    const When after_fused = plan.fuses ? When::where_fused_ends : When::until_rays_end;
    add(march_pass(one, plan, Origin::eye, after_fused));
    add(active_pass(after_fused));
    const When once = plan.fuses ? When::where_fused_ends : When::once_a_tile;
    if (keeps_surfaces(one)) add(surface_pass(one, plan, Origin::eye, once));
    if (has_mirrored_rays(one)) {
        // A page has no such masks.
        if (!one.is_alone() && one.index == 0 && !on_web) add(mirror_mask_pass(one.scene));
        add(march_pass(one, plan, Origin::mirror, When::until_rays_end));
        add(surface_pass(one, plan, Origin::mirror, When::once_a_tile));
        if (!one.is_alone()) add(seen_pass(one, plan));
    }
    if (follows_paths(one.scene))
        add_all(path_passes(one, plan));
    else if (has_glass(one))
        add_all(glass_passes(one, plan));
    if (shadow_mask(one.scene) != 0) add(shadow_pass(one, plan));
    if (!one.is_alone() && one.scene.occlusion) add(occlusion_pass(one, plan));
    add(shade_pass(one, plan, once));
    if (std::ranges::find(channels, Channel::velocity) != channels.end())
        add(motion_pass(one, plan));
    if (one.surface.isolation.certify) add_all(proof_passes(one, plan));
    if (on_web) {
        for (Pass& pass : list) become_glsl_es(pass);
    }
    return list;
}

// How many elements the surface's arrays have over all times.
std::vector<formula::ElementRange> element_ranges(const animation::Animation& animation) {
    std::vector<formula::ElementRange> ranges;
    for (const animation::Array& array : animation.arrays())
        ranges.push_back({array.samples ? 0 : array.count, array.count});
    return ranges;
}

Passes assemble_with(const std::shared_ptr<const FieldTapes>& tapes, const scene::OneSurface& one,
                     const std::vector<Channel>& channels, const Drawing& drawing,
                     double size_compiled = 0) {
    const PassPlan plan = plan_of(tapes, one, channels, drawing);
    return {plan, passes_of(one, plan, channels, drawing.platform == Platform::webgl),
            size_compiled};
}

} // namespace

Passes assemble(const scene::OneSurface& one, const std::vector<Channel>& channels,
                const Drawing& drawing) {
    const Passes compiled = assemble_with(nullptr, one, channels, drawing);
    const double size = inlined_size(compiled);
    if (drawing.platform == Platform::webgl || size <= largest_shaders()) return compiled;
    const auto tapes = FieldTapes::of(*one.surface.field, one.surface.parameters,
                                      element_ranges(one.surface.animation));
    if (!tapes) return compiled;
    return assemble_with(tapes, one, channels, drawing, size);
}

} // namespace isomotion::shader
