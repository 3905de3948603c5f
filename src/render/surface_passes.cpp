#include "render/surface_passes.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "render/arithmetic_speed.h"
#include "shader/inlined_size.h"
#include "shader/surfaces_text.h"
#include "shader/tape_text.h"

namespace isomotion::render {
namespace {

// Texels that the buffer of an array with lists may have: beams write lists into it as a storage
// block and others read them as a texture. Elements are told by floats, too.
int texels_for_lists(const gpu::ContextInfo& info) {
    return std::min({info.max_texture_buffer_size,
                     info.max_storage_block_size / int(sizeof(glm::vec4)), 1 << 24});
}

// Drivers of hardware have compilers of their own: the limit is of Mesa's for processors.
const shader::Passes& checked(const shader::Passes& passes, const gpu::ContextInfo& info) {
    if (info.software) shader::check_size(passes);
    return passes;
}

// What is written must not depend on the number of threads. How far proofs get depends on a tile's
// size, and so do lists that are too long for theirs.
DrawLimits limits_of_a_draw(const gpu::ContextInfo& info, const scene::OneSurface& one,
                            const shader::Passes& passes) {
    constexpr int most_in_any_list = 500;
    const bool keeps_tiles =
        one.surface.isolation.certify ||
        (shader::has_lists(passes) && passes.arrays[0].capacity > most_in_any_list);
    return {.operations = operations_per_draw_at(arithmetic_speed(info).in(passes.stage)),
            .threads = keeps_tiles ? 1 : std::max(1, info.threads)};
}

// Whether all that is drawn of a tile follows the table's corner(), and pixels are the same there.
// Lists of elements are made for blocks of up to 64 pixels, which would be others.
bool spreads_small_pictures(const gpu::ContextInfo& info, const scene::OneSurface& one,
                            const shader::Passes& passes) {
    return info.software && info.max_texture_size >= side_for_small_pictures &&
           passes.stage == shader::Stage::fragment && !one.surface.isolation.certify &&
           !passes.has(shader::Role::motion) &&
           std::ranges::all_of(passes.beams, [](const shader::BeamLevel& level) {
               return level.block == Blocks::side;
           });
}

// Lists lie behind the elements that they list.
int first_list(const shader::Passes& passes) {
    return passes.arrays.empty() ? 0 : passes.arrays[0].capacity;
}

std::optional<BeamPass> beams_of_eye(const PlannedSurface& of, const gpu::ContextInfo& info) {
    if (of.passes.beams.empty()) return std::nullopt;
    return BeamPass(of.passes, of.drawn, of.plan.march, texels_for_lists(info),
                    first_list(of.passes));
}

// `listed`: by the beams of the eye.
std::optional<LightBeams> beams_of_lights(const PlannedSurface& of, const RenderOptions& options,
                                          const gpu::ContextInfo& info, int listed) {
    if (of.passes.light_beams == 0) return std::nullopt;
    return LightBeams(of.passes, of.drawn, light_pixels(options.width, options.height),
                      texels_for_lists(info), first_list(of.passes) + listed);
}

int listed_by(const auto& beams) { return beams ? beams->listed() : 0; }

// Each surface keeps the states of its rays: smaller tiles keep that in bounds.
constexpr int largest_tile_of_several = 512;

} // namespace

PlannedSurface::PlannedSurface(const scene::OneSurface& one, const RenderOptions& options,
                               const gpu::ContextInfo& info)
    : drawn(one)
    , passes(shader::assemble(one, options.channels,
                              {.stage = choose_stage(options.stage, info),
                               .branches = options.branches.value_or(!info.software),
                               .writes_buffers = info.has(4, 3),
                               .finest_beam = options.finest_beam,
                               .tells_endings = options.tells_endings,
                               .pixels = options.pixels > 0
                                             ? options.pixels
                                             : std::int64_t(options.width) * options.height}))
    , plan(plan_scene(one, checked(passes, info), options.width, options.height,
                      info.max_texture_size, options.plan, limits_of_a_draw(info, one, passes))) {
    // Whether one draw may end a ray, by the usual budget: the passes, and so the fingerprint, are
    // not to depend on how fast this machine is today.
    const ScenePlan usual =
        plan_scene(one, passes, options.width, options.height, info.max_texture_size, options.plan);
    if (usual.march.evaluations_per_pass <= 1)
        passes = shader::without_fused_pass(std::move(passes));
    plan.march.spreads_small_pictures = !options.plan && spreads_small_pictures(info, one, passes);
}

std::vector<PlannedSurface> plan_surfaces(const scene::Scene& scene, const RenderOptions& options,
                                          const gpu::ContextInfo& info) {
    std::vector<PlannedSurface> all;
    all.reserve(scene.surfaces.size());
    for (std::size_t k = 0; k < scene.surfaces.size(); ++k)
        all.emplace_back(scene::OneSurface(scene, k), options, info);
    if (all.size() == 1) return all;
    std::vector<shader::Passes*> passes;
    passes.reserve(all.size());
    for (PlannedSurface& each : all) passes.push_back(&each.passes);
    shader::agree_on_draws(passes);
    int width = largest_tile_of_several, height = largest_tile_of_several;
    for (const PlannedSurface& each : all) {
        width = std::min(width, each.plan.march.tile_width);
        height = std::min(height, each.plan.march.tile_height);
    }
    const bool all_spread = std::ranges::all_of(
        all, [](const PlannedSurface& each) { return each.plan.march.spreads_small_pictures; });
    for (PlannedSurface& each : all) {
        each.plan.march.tile_width = width;
        each.plan.march.tile_height = height;
        each.plan.march.spreads_small_pictures = all_spread;
    }
    return all;
}

SurfacePasses::SurfacePasses(PlannedSurface planned, const RenderOptions& options,
                             const gpu::ContextInfo& info, std::function<void()> stop_if_asked)
    : planned_(std::move(planned))
    , drawn(planned_.drawn)
    , passes(planned_.passes)
    , plan(planned_.plan)
    , table(passes)
    , marcher(passes, drawn.scene, plan, std::move(stop_if_asked))
    , beams(beams_of_eye(planned_, info))
    , light_beams(beams_of_lights(planned_, options, info, listed_by(beams)))
    , field(passes, listed_by(beams) + listed_by(light_beams))
    , frame_(sizeof(FrameBlock))
    , shading_((7 + 2 * drawn.scene.lights.size()) * sizeof(glm::vec4))
    , threads_(options.threads)
    , most_listed_(std::size_t(info.max_texture_buffer_size)) {
    if (passes.tapes) tapes_are_run_ = passes.tapes->are_run(passes);
    if (const auto array = shader::array_with_grid(passes))
        grid_maker_ = elements::GridMaker::of(*drawn.surface.field, *array);
}

InputLayout SurfacePasses::layout(int width, int height) const {
    const int light_side =
        light_beams ? std::min(light_beams->most_pixels(), light_pixels(width, height)) : 0;
    InputLayout all{passes, width, height, light_side};
    const int threads =
        threads_ > 0 ? threads_ : std::max(1, int(std::thread::hardware_concurrency()));
    all.tape_limits.threads = threads;
    all.tape_limits.are_run = tapes_are_run_;
    all.tape_limits.instructions = std::min(all.tape_limits.instructions, most_listed_ / 4);
    if (!grid_maker_) return all;
    all.grid = &*grid_maker_;
    all.most_elements_at_a_place = plan.most_elements_at_a_place;
    all.grid_limits.threads = threads;
    all.grid_limits.listed = std::min(all.grid_limits.listed, most_listed_);
    return all;
}

SurfaceInputs SurfacePasses::prepare(const scene::SceneAt& now, const scene::Aim& aim,
                                     const Motion* motion, int width, int height,
                                     SharedField& field_of_frame) {
    return surface_inputs(drawn, {now, drawn.index}, aim, motion, layout(width, height),
                          element_radius_, field_of_frame);
}

void SurfacePasses::upload(const SurfaceInputs& inputs, int width, int height) {
    frame_.update(std::as_bytes(std::span(&inputs.eye.frame, 1)));
    table.bind("Frame", frame_);
    shading_.update(std::as_bytes(std::span(inputs.shading)));
    table.bind("Shading", shading_);
    field.upload(table, *inputs.field);
    table.set(inputs.effects);
    if (light_beams) {
        light_beams->draw(table, inputs.lights, layout(width, height).light_pixels, field.listed());
    }
}

void SurfacePasses::bind() {
    table.bind("Frame", frame_);
    table.bind("Shading", shading_);
    field.bind(table);
    if (light_beams) light_beams->bind(table);
}

void SurfacePasses::draw_beams(const SurfaceInputs& inputs, const gpu::Rectangle& tile) {
    if (!beams) return;
    if (keeps_beams) return beams->bind(table, "beam");
    const glm::ivec2 corner = table.corner();
    table.timed([&] {
        beams->draw(table, inputs.eye.beams, {corner.x, corner.y, tile.width, tile.height},
                    glm::ivec2(tile.x, tile.y) - corner, field.listed());
    });
}

} // namespace isomotion::render
