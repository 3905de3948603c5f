#include "render/beam_pass.h"

#include <algorithm>

#include <fmt/format.h>

#include "render/blocks.h"

namespace isomotion::render {
namespace {

int blocks_in(int length, int block) { return (length + block - 1) / block; }

// Of squares of that many pixels, which are kept apart.
int texels_of(int length, int square) { return blocks_in(length, square) * synthesis::beam_square; }

int blocks_in(const MarchPlan& tile, int block) {
    return blocks_in(tile.tile_width, block) * blocks_in(tile.tile_height, block);
}

// Elements in one list of a level: what large blocks pass on, smaller ones go through.
int longest_list(const synthesis::BeamShader& level, int capacity) {
    if (level.lists == synthesis::BeamLists::none) return 0;
    return std::min(16 * level.block, capacity);
}

// The part of the longest lists that a buffer of so many texels has room for.
double part_of_lists(const synthesis::Shaders& shaders, const MarchPlan& plan, int texels) {
    if (!synthesis::has_lists(shaders)) return 0;
    const auto& array = shaders.arrays[0];
    double wanted = 0;
    for (const auto& level : shaders.beams) {
        wanted += double(blocks_in(plan, level.block)) * longest_list(level, array.capacity);
    }
    return std::clamp((texels / array.texels - array.capacity) / wanted, 0.0, 1.0);
}

// What fits into the loops of a beam's shader; with lists it is less where these are long.
int evaluations_of_a_beam(const synthesis::Shaders& shaders, const formula::Field& field,
                          synthesis::BeamLists lists) {
    // Where lists are made for smaller blocks, these walk the rest of the way at a smaller price.
    const double most = lists == synthesis::BeamLists::whole ? 8 : 64;
    std::vector<int> counts;
    for (const auto& array : shaders.arrays) counts.push_back(array.capacity);
    const double sums = formula::cost(field.value, counts).iterations;
    const double fitting = 0.5 * loop_iterations_per_pass / (1 + sums);
    return int(synthesis::has_lists(shaders) ? most : std::min(most, fitting));
}

} // namespace

BeamPass::BeamPass(const synthesis::Shaders& shaders, const scene::Scene& scene,
                   const MarchPlan& plan, int texels, int unit)
    : unit_(unit) {
    const int elements = shaders.arrays.empty() ? 0 : shaders.arrays[0].capacity;
    const double part = part_of_lists(shaders, plan, texels);
    for (const synthesis::BeamShader& level : shaders.beams) {
        const int block = level.block, square = block << level.square_bits;
        const int length = int(part * longest_list(level, elements));
        levels_.push_back(
            {gpu::Program(shaders.vertex, level.text, fmt::format("beam {}", block)),
             gpu::Target(texels_of(plan.tile_width, square), texels_of(plan.tile_height, square),
                         synthesis::has_lists(shaders) ? 2 : 1),
             block, level.square_bits,
             evaluations_of_a_beam(shaders, *scene.surface.field, level.lists),
             glm::ivec3(elements + listed_, length, blocks_in(plan.tile_width, block))});
        listed_ += blocks_in(plan, block) * length;
    }
}

void BeamPass::for_each_program(const std::function<void(const gpu::Program&)>& visit) const {
    for (const Level& level : levels_) visit(level.program);
}

void BeamPass::upload(const scene::SceneAt& now, int width, int height,
                      const scene::Aim& aim) const {
    for (const Level& level : levels_) {
        level.program.set("beam", beam_range(now, width, height, aim, level.block));
        level.program.set("beam_evaluations", level.evaluations);
    }
}

void BeamPass::Level::bind_results(int unit) const {
    for (int k = 0; k < results.attachments(); ++k) results.texture(k).bind(unit + k);
}

void BeamPass::draw(const gpu::Rectangle& tile, const ArrayBuffer* array) const {
    const Level* before = nullptr;
    for (const Level& level : levels_) {
        if (array) array->bind_for_lists();
        if (before) before->bind_results(unit_);
        level.program.set("tile_origin", glm::ivec2(tile.x, tile.y));
        level.program.set("list", level.list);
        level.results.bind();
        level.program.use();
        const int across = blocks_in(tile.width, level.block);
        const int up = blocks_in(tile.height, level.block), side = 1 << level.square_bits;
        for (int y = 0; y < up; y += side) {
            for (int x = 0; x < across; x += side) {
                // No blocks beyond the tile: these would write other blocks' lists.
                gpu::set_viewport({x / side * synthesis::beam_square,
                                   y / side * synthesis::beam_square, std::min(side, across - x),
                                   std::min(side, up - y)});
                triangle_.draw();
            }
        }
        if (array) array->wait_for_lists();
        before = &level;
    }
    before->bind_results(unit_);
}

} // namespace isomotion::render
