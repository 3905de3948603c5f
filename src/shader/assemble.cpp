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

// With these tapes for the field, or the field's own code.
Passes assemble_with(const std::shared_ptr<const FieldTapes>& tapes, const scene::OneSurface& one,
                     const std::vector<Channel>& channels, const Drawing& drawing) {
    const Stage stage = drawing.stage;
    const scene::MethodTraits& method = scene::traits(one.surface.isolation.method);
    const bool on_web = drawing.platform == Platform::webgl;
    Passes passes;
    passes.stage = stage;
    passes.branches = drawing.branches;
    // A wall's normal is no slope along a ray.
    passes.march_takes_gradient =
        !tapes && is_long(one.surface.field->gradient) && !one.surface.jumps_are_walls;
    passes.samples = samples_of(one, passes.march_takes_gradient);
    passes.state_textures = method.state_textures;
    const auto find_elements = [&](bool keeps_copies) {
        static_cast<FieldStorage&>(passes) = storage_of_elements(one, drawing, keeps_copies);
        passes.tapes = tapes;
        // A page's beams that keep no bits find elements by place as its rays do.
        const bool by_beams = uses_beams(one) && (on_web || !array_with_grid(passes)) &&
                              pays_in(stage, one, has_lists(passes));
        passes.beams =
            by_beams ? beam_levels(passes, drawing.finest_beam) : std::vector<BeamLevel>{};
    };
    find_elements(true);
    if (has_copies(passes) && !copies_fit(passes)) find_elements(false);
    const bool settling_pays = drawing.pixels >= fewest_to_settle || pays_in(stage, one, false);
    if (!on_web && !tapes && settling_pays && can_settle_blocks(one, drawing.finest_beam))
        passes.beams.push_back(level_by_models(drawing.finest_beam));
    if (!passes.beams.empty() && !on_web)
        passes.light_beams = shadow_mask(one.scene) & far_lights(one.scene);
    std::vector<Channel> wanted = channels;
    if (one.surface.isolation.certify || drawing.tells_endings) wanted.push_back(Channel::ending);
    if (one.surface.isolation.certify && !one.is_alone()) wanted.push_back(Channel::surface);
    passes.attachments = written_channels(wanted);
    const bool fuses =
        stage == Stage::fragment && can_fuse(one, channels, int(passes.attachments.size()));
    passes.draws_squares = fuses && one.is_alone() && !on_web;

    const auto add = [&](Pass pass) { passes.list.push_back(std::move(pass)); };
    for (std::size_t level = 0; level < passes.beams.size(); ++level) {
        add(beam_pass(one, passes, int(level)));
        if (has_copies(passes)) add(beam_copies_pass(one, passes, int(level)));
    }
    if (fuses) {
        if (!passes.draws_squares) add(mask_pass(one, passes));
        if (settles_blocks(passes)) add(settled_pass(one, passes));
        add(fused_pass(one, passes));
    }
    const When after_fused = fuses ? When::where_fused_ends : When::until_rays_end;
    add(march_pass(one, passes, Origin::eye, after_fused));
    add(active_pass(after_fused));
    const When once = fuses ? When::where_fused_ends : When::once_a_tile;
    if (keeps_surfaces(one)) add(surface_pass(one, passes, Origin::eye, once));
    if (has_mirrored_rays(one)) {
        // A page has no such masks.
        if (!one.is_alone() && one.index == 0 && !on_web) add(mirror_mask_pass(one.scene));
        add(march_pass(one, passes, Origin::mirror, When::until_rays_end));
        add(surface_pass(one, passes, Origin::mirror, When::once_a_tile));
        if (!one.is_alone()) add(seen_pass(one, passes));
    }
    if (follows_paths(one.scene)) {
        for (Pass& pass : path_passes(one, passes)) add(std::move(pass));
    } else if (has_glass(one)) {
        for (Pass& pass : glass_passes(one, passes)) add(std::move(pass));
    }
    if (shadow_mask(one.scene) != 0) add(shadow_pass(one, passes));
    if (!one.is_alone() && one.scene.occlusion) add(occlusion_pass(one, passes));
    add(shade_pass(one, passes, once));
    if (std::find(channels.begin(), channels.end(), Channel::velocity) != channels.end()) {
        add(motion_pass(one, passes));
    }
    if (one.surface.isolation.certify) {
        for (Pass& pass : proof_passes(one, passes)) add(std::move(pass));
    }
    if (on_web) {
        for (Pass& pass : passes.list) become_glsl_es(pass);
    }
    return passes;
}

} // namespace

Passes assemble(const scene::OneSurface& one, const std::vector<Channel>& channels,
                const Drawing& drawing) {
    Passes compiled = assemble_with(nullptr, one, channels, drawing);
    const double size = inlined_size(compiled);
    if (drawing.platform == Platform::webgl || size <= largest_shaders()) return compiled;
    const auto tapes = FieldTapes::of(*one.surface.field);
    if (!tapes) return compiled;
    Passes run = assemble_with(tapes, one, channels, drawing);
    run.size_compiled = size;
    return run;
}

} // namespace isomotion::shader
