#include "synthesis/assemble.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <span>

#include "formula/element_kernels.h"
#include "formula/linear_sum.h"
#include "synthesis/beam_copies_text.h"
#include "synthesis/beam_text.h"
#include "synthesis/effect.h"
#include "synthesis/effect_text.h"
#include "synthesis/glass_text.h"
#include "synthesis/march_text.h"
#include "synthesis/paths_text.h"
#include "synthesis/proof_text.h"
#include "synthesis/shade_text.h"
#include "synthesis/surfaces_text.h"

namespace isomotion::synthesis {
namespace {

// With more elements than these, a grid finds those that matter faster than beams do.
constexpr int most_by_lists = 500;
// The same in GLSL ES where beams keep neither lists nor bits: with more elements than these, a
// grid is faster than beams that go through all.
constexpr int most_in_beams_of_a_page = 24;

// Whether rays ask for bounds of F over pieces of them.
bool goes_by_bounds(const scene::Scene& scene) {
    switch (scene.isolation.method) {
    case scene::Method::interval:
    case scene::Method::affine:
    case scene::Method::sphere:
        return true;
    case scene::Method::hermite:
        return !scene.surface.smoothness.is_smooth();
    default:
        return false;
    }
}

// The array with the most elements, if its sums' terms are kernels of a distance and looking for
// them pays. A scene that calls beams off looks at all elements, and so do the paper's methods, as
// far as a shader can.
std::optional<int> array_to_find_by_place(const scene::Scene& scene, std::span<const int> counts,
                                          Platform platform) {
    constexpr int fewest_on_desktops = 64, most_in_a_shader = 20'000;
    const int fewest = platform == Platform::webgl ? most_in_beams_of_a_page : fewest_on_desktops;
    if (counts.empty()) return std::nullopt;
    const int array = int(std::ranges::max_element(counts) - counts.begin());
    const int count = counts[std::size_t(array)];
    const bool looks_at_all = scene.isolation.beam == false;
    const bool is_hermite = scene.isolation.method == scene::Method::hermite;
    // Bounds over a box take all other arrays in each of its cells, of which a draw has
    // MOST_ELEMENTS at most (field_text.cpp): proofs come to boxes of two cells, marches by bounds
    // need some eight.
    constexpr int most_of_others = 2000, most_by_bounds = 500;
    const int others = std::accumulate(counts.begin(), counts.end(), 0) - count;
    if (others > most_of_others && scene.isolation.certify) return std::nullopt;
    if (others > most_by_bounds && goes_by_bounds(scene)) return std::nullopt;
    const int from = looks_at_all ? most_in_a_shader : is_hermite ? fewest : most_by_lists;
    if (count <= from || !formula::element_kernels(*scene.surface.field, array))
        return std::nullopt;
    return array;
}

// `keeps_copies`: where shaders can write no lists, these may be copies.
FieldStorage storage_of(const scene::Scene& scene, bool writes_buffers, bool keeps_copies,
                        Platform platform) {
    const std::vector<int> counts = scene.timeline.animation.counts();
    // With more elements than most the loops of a beam's shader might end too soon (beam_text.cpp).
    constexpr int fewest = 9, most = 15'000;
    const auto by_place = array_to_find_by_place(scene, counts, platform);
    const bool is_large =
        by_place && counts[std::size_t(*by_place)] > most_by_lists && scene.isolation.beam != true;
    Finding finding;
    // Rays that begin on a surface have no beams there, and find elements faster by place.
    finding.by_copies = keeps_copies && platform == Platform::webgl && !keeps_surfaces(scene) &&
                        by_place.value_or(0) == 0 && !counts.empty() && counts[0] <= most_in_copies;
    const bool keeps_lists = writes_buffers || finding.by_copies;
    finding.by_lists = !is_large && keeps_lists && uses_beams(scene) && !counts.empty() &&
                       counts[0] >= fewest && counts[0] <= most &&
                       formula::linear_sum(*scene.surface.field).has_value();
    if (!finding.by_lists) finding.by_place = by_place;
    return field_storage(*scene.surface.field, scene.surface.parameters, counts, finding);
}

// The rest is the prelude's.
void become_glsl_es(Pass& pass) {
    for (std::string* text : {&pass.vertex, &pass.text})
        text->replace(0, text->find('\n'), "#version 300 es");
}

// Whether beams by intervals do. Compute shaders are for hardware with more lanes than a picture
// has blocks, where a walk along a beam takes longer than it saves, but for lists of elements.
bool pays_in(Stage stage, const scene::Scene& scene, bool makes_lists) {
    return stage == Stage::fragment || makes_lists || scene.isolation.beam.value_or(false);
}

// From so many pixels on an H100 has enough blocks to settle (docs/performance.md).
constexpr std::int64_t fewest_to_settle = 2'000'000;

// Whether a gradient is so long that compiling it is felt: some 0.2 s on a software renderer,
// growing with its length.
bool is_long(const formula::Program& gradient) { return gradient.instructions.size() > 1000; }

} // namespace

Passes assemble(const scene::Scene& scene, const std::vector<Channel>& channels,
                const Drawing& drawing) {
    const Stage stage = drawing.stage;
    const scene::MethodTraits& method = scene::traits(scene.isolation.method);
    const bool on_web = drawing.platform == Platform::webgl;
    Passes passes;
    passes.stage = stage;
    // A wall's normal is no slope along a ray.
    passes.march_takes_gradient =
        is_long(scene.surface.field->gradient) && !scene.surface.jumps_are_walls;
    passes.samples = samples_of(scene, passes.march_takes_gradient);
    passes.state_textures = method.state_textures;
    const auto find_elements = [&](bool keeps_copies) {
        static_cast<FieldStorage&>(passes) =
            storage_of(scene, drawing.writes_buffers && !on_web, keeps_copies, drawing.platform);
        // A page's beams that keep no bits find elements by place as its rays do.
        const bool by_beams = uses_beams(scene) && (on_web || !array_with_grid(passes)) &&
                              pays_in(stage, scene, has_lists(passes));
        passes.beams =
            by_beams ? beam_levels(passes, drawing.finest_beam) : std::vector<BeamLevel>{};
    };
    find_elements(true);
    if (has_copies(passes) && !copies_fit(passes)) find_elements(false);
    const bool settling_pays = drawing.pixels >= fewest_to_settle || pays_in(stage, scene, false);
    if (!on_web && settling_pays && can_settle_blocks(scene, drawing.finest_beam))
        passes.beams.push_back(level_by_models(drawing.finest_beam));
    if (!passes.beams.empty() && !on_web)
        passes.light_beams = shadow_mask(scene) & far_lights(scene);
    std::vector<Channel> wanted = channels;
    if (scene.isolation.certify || drawing.tells_endings) wanted.push_back(Channel::ending);
    if (scene.isolation.certify && is_among(scene)) wanted.push_back(Channel::surface);
    passes.attachments = written_channels(wanted);
    const bool fuses =
        stage == Stage::fragment && can_fuse(scene, channels, int(passes.attachments.size()));
    passes.draws_squares = fuses && !is_among(scene) && !on_web;

    const auto add = [&](Pass pass) { passes.list.push_back(std::move(pass)); };
    for (std::size_t level = 0; level < passes.beams.size(); ++level) {
        add(beam_pass(scene, passes, int(level)));
        if (has_copies(passes)) add(beam_copies_pass(scene, passes, int(level)));
    }
    if (fuses) {
        if (!passes.draws_squares) add(mask_pass(scene, passes));
        if (settles_blocks(passes)) add(settled_pass(scene, passes));
        add(fused_pass(scene, passes));
    }
    const When after_fused = fuses ? When::where_fused_ends : When::until_rays_end;
    add(march_pass(scene, passes, Origin::eye, after_fused));
    add(active_pass(after_fused));
    const When once = fuses ? When::where_fused_ends : When::once_a_tile;
    if (keeps_surfaces(scene)) add(surface_pass(scene, passes, Origin::eye, once));
    if (has_mirrored_rays(scene)) {
        // A page has no such masks.
        if (is_among(scene) && is_first(scene) && !on_web) add(mirror_mask_pass(scene));
        add(march_pass(scene, passes, Origin::mirror, When::until_rays_end));
        add(surface_pass(scene, passes, Origin::mirror, When::once_a_tile));
        if (is_among(scene)) add(seen_pass(scene, passes));
    }
    if (follows_paths(scene)) {
        for (Pass& pass : path_passes(scene, passes)) add(std::move(pass));
    } else if (has_glass(scene)) {
        for (Pass& pass : glass_passes(scene, passes)) add(std::move(pass));
    }
    if (shadow_mask(scene) != 0) add(shadow_pass(scene, passes));
    if (is_among(scene) && scene.occlusion) add(occlusion_pass(scene, passes));
    add(shade_pass(scene, passes, once));
    if (std::find(channels.begin(), channels.end(), Channel::velocity) != channels.end()) {
        add(motion_pass(scene, passes));
    }
    if (scene.isolation.certify) {
        for (Pass& pass : proof_passes(scene, passes)) add(std::move(pass));
    }
    if (on_web) {
        for (Pass& pass : passes.list) become_glsl_es(pass);
    }
    return passes;
}

} // namespace isomotion::synthesis
