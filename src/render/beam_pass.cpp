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

int length_of_lists(const synthesis::Shaders& shaders, const MarchPlan& plan, int texels) {
    if (!synthesis::has_lists(shaders)) return 0;
    constexpr int longest = 256;
    int blocks = 1;
    for (const auto& level : shaders.beams) {
        if (level.lists != synthesis::BeamLists::none) blocks += blocks_in(plan, level.block);
    }
    const auto& array = shaders.arrays[0];
    const int room = texels / array.texels - array.capacity;
    return std::max(0, std::min({longest, array.capacity, room / blocks}));
}

// What fits into the loops of a beam's shader; with lists it is less where these are long.
int evaluations_of_a_beam(const synthesis::Shaders& shaders, const formula::Field& field) {
    constexpr double most = 64;
    std::vector<int> counts;
    for (const auto& array : shaders.arrays) counts.push_back(array.capacity);
    const double sums = formula::cost(field.value, counts).iterations;
    const double fitting = 0.5 * loop_iterations_per_pass / (1 + sums);
    return int(synthesis::has_lists(shaders) ? most : std::min(most, fitting));
}

} // namespace

BeamPass::BeamPass(const synthesis::Shaders& shaders, const scene::Scene& scene,
                   const MarchPlan& plan, int texels, int unit)
    : list_length_(length_of_lists(shaders, plan, texels))
    , evaluations_(evaluations_of_a_beam(shaders, *scene.surface.field))
    , unit_(unit) {
    const int elements = shaders.arrays.empty() ? 0 : shaders.arrays[0].capacity;
    for (const auto& [block, lists, bits, text] : shaders.beams) {
        levels_.push_back({gpu::Program(shaders.vertex, text, fmt::format("beam {}", block)),
                           gpu::Target(texels_of(plan.tile_width, block << bits),
                                       texels_of(plan.tile_height, block << bits),
                                       synthesis::has_lists(shaders) ? 2 : 1),
                           block, bits, blocks_in(plan.tile_width, block), elements + listed_});
        if (lists != synthesis::BeamLists::none) listed_ += blocks_in(plan, block) * list_length_;
    }
}

void BeamPass::for_each_program(const std::function<void(const gpu::Program&)>& visit) const {
    for (const Level& level : levels_) visit(level.program);
}

void BeamPass::upload(const scene::SceneAt& now, int width, int height,
                      const scene::Aim& aim) const {
    for (const Level& level : levels_) {
        level.program.set("beam", beam_range(now, width, height, aim, level.block));
        level.program.set("beam_evaluations", evaluations_);
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
        level.program.set("list", glm::ivec3(level.first_list, list_length_, level.blocks_across));
        level.results.bind();
        level.program.use();
        const int square = level.block << level.square_bits, side = 1 << level.square_bits;
        for (int y = 0; y < blocks_in(tile.height, square); ++y) {
            for (int x = 0; x < blocks_in(tile.width, square); ++x) {
                gpu::set_viewport(
                    {x * synthesis::beam_square, y * synthesis::beam_square, side, side});
                triangle_.draw();
            }
        }
        if (array) array->wait_for_lists();
        before = &level;
    }
    before->bind_results(unit_);
}

} // namespace isomotion::render
