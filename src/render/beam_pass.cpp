#include "render/beam_pass.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "render/scene_plan.h"

namespace isomotion::render {
namespace {

int blocks_in(int length, int block) { return (length + block - 1) / block; }

// Texels for squares of that many pixels, which are kept apart.
int texels_apart(int length, int square) { return blocks_in(length, square) * shader::beam_square; }

// Draws these blocks, whose squares are `side` blocks across; none beyond them.
void draw_apart(const gpu::Fullscreen& triangle, const gpu::Rectangle& blocks, int side) {
    const int right = blocks.x + blocks.width, top = blocks.y + blocks.height;
    for (int y = blocks.y / side * side; y < top; y += side) {
        for (int x = blocks.x / side * side; x < right; x += side) {
            const int left = std::max(blocks.x - x, 0), low = std::max(blocks.y - y, 0);
            gpu::set_viewport({x / side * shader::beam_square + left,
                               y / side * shader::beam_square + low,
                               std::min(side, right - x) - left, std::min(side, top - y) - low});
            triangle.draw();
        }
    }
}

// Of a walk by models. Neighbours wait for the longest walk: on an H100, ends after 24 pieces take
// 7 % less time than after 64, for five surfaces in the mean, rays included.
constexpr int most_pieces_in_compute = 24;

int blocks_of(const MarchPlan& tile, int block) {
    return blocks_in(tile.tile_width, block) * blocks_in(tile.tile_height, block);
}

// Elements in one list of a level: what large blocks pass on, smaller ones go through. Where there
// are few blocks there is room for more.
int longest_list(const shader::BeamLevel& level, const MarchPlan& tile, int capacity) {
    if (level.lists == shader::BeamLists::none) return 0;
    constexpr int room = 1 << 21; // of a level
    const int lists = blocks_of(tile, level.block) * lists_of_a_block(level);
    return std::min(std::max(16 * level.block, room / lists), capacity);
}

// The part of the longest lists that a buffer of so many texels has room for behind `first`.
double part_of_lists(const shader::Passes& passes, const MarchPlan& plan, int texels, int first) {
    if (!shader::has_lists(passes)) return 0;
    const auto& array = passes.arrays[0];
    double wanted = 0;
    for (const auto& level : passes.beams) {
        wanted += double(blocks_of(plan, level.block)) * lists_of_a_block(level) *
                  longest_list(level, plan, array.capacity);
    }
    const int elements = texels / array.texels; // whole ones
    return std::clamp((elements - first) / wanted, 0.0, 1.0);
}

} // namespace

int evaluations_of_a_beam(const shader::Passes& passes, const formula::Field& field,
                          shader::BeamLists lists) {
    // Where lists are made for smaller blocks, these walk the rest of the way at a smaller price.
    const double most = lists == shader::BeamLists::whole ? 8 : 64;
    using shader::FieldFunction;
    const FieldFunction bounds =
        passes.tapes ? FieldFunction::value_interval : FieldFunction::value; // as many sums
    const formula::Cost cost = shader::cost(field, passes, {bounds}, elements_by_place(passes));
    const double sums = cost.iterations + shader::turns_of_noise_bounds * cost.noises;
    const double fitting = 0.5 * loop_iterations_per_pass / (1 + sums);
    return int(shader::has_lists(passes) ? most : std::min(most, fitting));
}

BeamPass::BeamPass(const shader::Passes& passes, const scene::OneSurface& one,
                   const MarchPlan& plan, int texels, int first_list)
    : computes_(passes.stage == shader::Stage::compute) {
    const double part = part_of_lists(passes, plan, texels, first_list);
    const int elements = passes.arrays.empty() ? 0 : passes.arrays[0].capacity;
    const auto evaluations = [&](const shader::BeamLevel& level) {
        const int most = evaluations_of_a_beam(passes, *one.surface.field, level.lists);
        const bool ends_early = computes_ && level.by_models && !one.surface.isolation.certify;
        return ends_early ? std::min(most, most_pieces_in_compute) : most;
    };
    for (const shader::BeamLevel& level : passes.beams) {
        const int block = level.block, side = block << level.square_bits;
        const int length = int(part * longest_list(level, plan, elements));
        levels_.push_back(
            {gpu::Target(texels_apart(plan.target_width(), side),
                         texels_apart(plan.target_height(), side),
                         level.by_models             ? 2
                         : shader::has_lists(passes) ? 3
                                                     : 1),
             block, level.square_bits, evaluations(level),
             glm::ivec3(first_list + listed_, length, blocks_in(plan.tile_width, block)),
             level.by_models});
        listed_ += blocks_of(plan, block) * lists_of_a_block(level) * length;
    }
}

void BeamPass::bind(const PassTable& table, const Level& level, const std::string& kind) {
    const std::array<const char*, 3> parts{"", level.by_models ? "_roots" : "_lists", "_all"};
    for (int k = 0; k < level.results.attachments(); ++k) {
        table.bind(fmt::format("{}{}_texture", kind, parts.at(std::size_t(k))),
                   level.results.texture(k));
    }
}

Blocks BeamPass::blocks(const gpu::Rectangle& pixels, bool at_once) {
    const Level& level = levels_.back();
    if (level.block != Blocks::side)
        throw std::logic_error(fmt::format("the last beams have {} pixels across", level.block));
    Blocks found(pixels.width, pixels.height);
    const int side = 1 << level.square_bits;
    const int left = pixels.x / Blocks::side, low = pixels.y / Blocks::side;
    const int right = left + found.across, top = low + found.up;
    const auto read = [&](int x, int y, int width, int height) {
        parts_.resize(4 * std::size_t(width) * std::size_t(height));
        level.results.read(0, x, y, width, height, parts_);
    };
    const int row = at_once ? texels_apart(right, side) : side;
    if (at_once) read(0, 0, row, texels_apart(top, side));
    const auto kind = [&](std::size_t texel) {
        const float* part = &parts_[4 * texel];
        if (!(part[0] < part[1])) return BlockKind::empty;
        return level.by_models && part[2] > 0 ? BlockKind::settled : BlockKind::open;
    };
    for (int y = low / side * side; y < top; y += side) {
        for (int x = left / side * side; x < right; x += side) {
            const int texel_x = x / side * shader::beam_square;
            const int texel_y = y / side * shader::beam_square;
            if (!at_once) read(texel_x, texel_y, side, side);
            const std::size_t first =
                at_once ? std::size_t(texel_y) * std::size_t(row) + texel_x : 0;
            for (int up = std::max(y, low); up < std::min(y + side, top); ++up) {
                for (int across = std::max(x, left); across < std::min(x + side, right); ++across) {
                    found.at(across - left, up - low) =
                        kind(first + std::size_t((up - y) * row + across - x));
                }
            }
        }
    }
    return found;
}

void BeamPass::bind(const PassTable& table, const std::string& kind) const {
    bind(table, levels_.back(), kind);
}

void BeamPass::draw(PassTable& table, std::span<const glm::vec4> ranges,
                    const gpu::Rectangle& pixels, glm::ivec2 origin, const ArrayBuffer* array,
                    double around) const {
    for (std::size_t k = 0; k < levels_.size(); ++k) {
        const Level& level = levels_[k];
        const gpu::Program& program = table.program(shader::Role::beams, int(k));
        if (array) array->bind_for_lists();
        if (k > 0) bind(table, levels_[k - 1], "beam");
        program.set("beam", ranges[k]);
        program.set("beam_evaluations", level.evaluations);
        program.set("around_middles", float(around));
        program.set("tile_origin", origin);
        program.set("list", level.list);
        // No blocks beyond these: they would write other blocks' lists.
        const gpu::Rectangle blocks{pixels.x / level.block, pixels.y / level.block,
                                    blocks_in(pixels.width, level.block),
                                    blocks_in(pixels.height, level.block)};
        if (computes_) {
            table.compute_beams(program, blocks, level.results);
        } else {
            level.results.bind();
            draw_apart(triangle_, blocks, 1 << level.square_bits);
        }
        if (array) array->wait_for_lists();
    }
    bind(table);
}

} // namespace isomotion::render
