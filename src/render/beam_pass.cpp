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

// Elements in one list of a level: what large blocks pass on, smaller ones go through. Where there
// are few blocks there is room for more.
int longest_list(const synthesis::BeamShader& level, const MarchPlan& tile, int capacity) {
    if (level.lists == synthesis::BeamLists::none) return 0;
    constexpr int room = 1 << 21; // of a level
    const int lists = blocks_in(tile, level.block) * lists_of_a_block(level);
    return std::min(std::max(16 * level.block, room / lists), capacity);
}

// The part of the longest lists that a buffer of so many texels has room for behind `first`.
double part_of_lists(const synthesis::Shaders& shaders, const MarchPlan& plan, int texels,
                     int first) {
    if (!synthesis::has_lists(shaders)) return 0;
    const auto& array = shaders.arrays[0];
    double wanted = 0;
    for (const auto& level : shaders.beams) {
        wanted += double(blocks_in(plan, level.block)) * lists_of_a_block(level) *
                  longest_list(level, plan, array.capacity);
    }
    const int elements = texels / array.texels; // whole ones
    return std::clamp((elements - first) / wanted, 0.0, 1.0);
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
    : first_(shaders.arrays.empty() ? 0 : shaders.arrays[0].capacity)
    , unit_(unit) {
    const double part = part_of_lists(shaders, plan, texels, first_);
    for (const synthesis::BeamShader& level : shaders.beams) {
        const auto label = fmt::format("beam {}", level.block);
        add_level(std::make_shared<gpu::Program>(shaders.vertex, level.text, label), shaders, level,
                  plan, evaluations_of_a_beam(shaders, *scene.surface.field, level.lists), part);
    }
}

BeamPass::BeamPass(const BeamPass& others, const synthesis::Shaders& shaders, int width, int height,
                   int texels)
    : first_(others.first_ + others.listed_)
    , unit_(others.unit_) {
    const MarchPlan plan{width, height, 0};
    const double part = part_of_lists(shaders, plan, texels, first_);
    for (std::size_t k = 0; k < shaders.beams.size(); ++k) {
        add_level(others.levels_[k].program, shaders, shaders.beams[k], plan,
                  others.levels_[k].evaluations, part);
    }
}

void BeamPass::add_level(std::shared_ptr<const gpu::Program> program,
                         const synthesis::Shaders& shaders, const synthesis::BeamShader& level,
                         const MarchPlan& plan, int evaluations, double part) {
    const int elements = shaders.arrays.empty() ? 0 : shaders.arrays[0].capacity;
    const int block = level.block, side = block << level.square_bits;
    const int length = int(part * longest_list(level, plan, elements));
    levels_.push_back(
        {std::move(program),
         gpu::Target(texels_of(plan.tile_width, side), texels_of(plan.tile_height, side),
                     synthesis::has_lists(shaders) ? 3 : 1),
         block, level.square_bits, evaluations,
         glm::ivec3(first_ + listed_, length, blocks_in(plan.tile_width, block))});
    listed_ += blocks_in(plan, block) * lists_of_a_block(level) * length;
}

void BeamPass::for_each_program(const std::function<void(const gpu::Program&)>& visit) const {
    for (const Level& level : levels_) visit(*level.program);
}

void BeamPass::upload(const scene::SceneAt& now, int width, int height, const scene::Aim& aim,
                      double around) const {
    for (const Level& level : levels_) {
        level.program->set("beam", beam_range(now, width, height, aim, level.block));
        level.program->set("beam_evaluations", level.evaluations);
        level.program->set("around_middles", float(around));
    }
}

void BeamPass::Level::bind_results(int unit) const {
    for (int k = 0; k < results.attachments(); ++k) results.texture(k).bind(unit + k);
}

void BeamPass::draw(const gpu::Rectangle& pixels, glm::ivec2 origin,
                    const ArrayBuffer* array) const {
    const Level* before = nullptr;
    for (const Level& level : levels_) {
        if (array) array->bind_for_lists();
        if (before) before->bind_results(unit_);
        level.program->set("tile_origin", origin);
        level.program->set("list", level.list);
        level.results.bind();
        level.program->use();
        const int side = 1 << level.square_bits;
        const int left = pixels.x / level.block, low = pixels.y / level.block;
        const int right = left + blocks_in(pixels.width, level.block);
        const int top = low + blocks_in(pixels.height, level.block);
        for (int y = low; y < top; y += side) {
            for (int x = left; x < right; x += side) {
                // No blocks beyond these: they would write other blocks' lists.
                gpu::set_viewport({x / side * synthesis::beam_square,
                                   y / side * synthesis::beam_square, std::min(side, right - x),
                                   std::min(side, top - y)});
                triangle_.draw();
            }
        }
        if (array) array->wait_for_lists();
        before = &level;
    }
    if (before) before->bind_results(unit_);
}

} // namespace isomotion::render
