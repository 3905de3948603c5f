#include "render/beam_pass.h"

#include <algorithm>

#include <fmt/format.h>

#include "render/blocks.h"

namespace isomotion::render {
namespace {

int blocks_in(int length, int block) { return (length + block - 1) / block; }

int blocks_in(const MarchPlan& tile, int block) {
    return blocks_in(tile.tile_width, block) * blocks_in(tile.tile_height, block);
}

int length_of_lists(const synthesis::Shaders& shaders, const MarchPlan& plan, int texels) {
    if (!synthesis::has_lists(shaders)) return 0;
    constexpr int longest = 256;
    int blocks = 1;
    for (const auto& level : shaders.beams) {
        if (level.makes_lists) blocks += blocks_in(plan, level.block);
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
    for (const auto& [block, makes_lists, text] : shaders.beams) {
        levels_.push_back(
            {gpu::Program(shaders.vertex, text, fmt::format("beam {}", block)),
             gpu::Target(blocks_in(plan.tile_width, block), blocks_in(plan.tile_height, block)),
             block, elements + listed_});
        if (makes_lists) listed_ += blocks_in(plan, block) * list_length_;
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

void BeamPass::draw(const gpu::Rectangle& tile, const ArrayBuffer* array) const {
    const Level* before = nullptr;
    for (const Level& level : levels_) {
        if (array) array->bind_for_lists();
        if (before) before->parts.texture(0).bind(unit_);
        level.program.set("tile_origin", glm::ivec2(tile.x, tile.y));
        level.program.set("list", glm::ivec3(level.first_list, list_length_, level.parts.width()));
        level.parts.bind();
        gpu::set_viewport(
            {0, 0, blocks_in(tile.width, level.block), blocks_in(tile.height, level.block)});
        level.program.use();
        triangle_.draw();
        if (array) array->wait_for_lists();
        before = &level;
    }
    before->parts.texture(0).bind(unit_);
}

} // namespace isomotion::render
