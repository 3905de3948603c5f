#include "render/proofs.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "render/doubles.h"
#include "render/proved_blocks.h"
#include "render/scene_plan.h"
#include "shader/proof_text.h"

namespace isomotion::render {
namespace {

using shader::ProofBounds, shader::Role;

// Elements that a piece goes through.
std::vector<int> elements_of_piece(const shader::Passes& passes) {
    std::vector<int> counts = elements_by_place(passes);
    if (const auto array = shader::array_with_grid(passes)) {
        constexpr int cells = 4; // that a piece meets
        int& elements = counts[std::size_t(*array)];
        elements = std::min(cells * elements, passes.arrays[std::size_t(*array)].capacity);
    }
    return counts;
}

formula::Cost cost_of_piece(const shader::Passes& passes, const scene::OneSurface& one,
                            ProofBounds bounds) {
    return shader::cost_of_piece(*one.surface.field, passes, bounds, elements_of_piece(passes));
}

bool fits_a_shader(const formula::Cost& piece) {
    return 1 + piece.iterations <= loop_iterations_per_pass;
}

formula::Cost cost_that_fits(const formula::Cost& piece) {
    if (!fits_a_shader(piece)) {
        throw std::length_error(
            fmt::format("a proof bounds {:.0f} terms for every piece; a shader can sum {:.0f}: "
                        "draw fewer elements or without certify",
                        piece.iterations, loop_iterations_per_pass - 1));
    }
    return piece;
}

// The pieces that one draw may bound on each of so many rays.
int pieces_of_draw(const formula::Cost& piece, double rays) {
    const double by_loops = loop_iterations_per_pass / (1 + piece.iterations);
    const double by_work = operations_per_draw / (rays * (piece.operations + 100));
    return int(std::clamp(std::min(by_work, by_loops), 1.0, double(Proofs::most_pieces)));
}

// The pieces after which rays that go on are packed anew, so that those that need few don't wait
// for neighbours that need many: waiting costs more than packing, as long as there are many. Dear
// pieces, as those of sums, are worth more of it.
int pieces_of_packing(const formula::Cost& piece, std::size_t rays) {
    constexpr std::size_t few = 256, a_handful = 32;
    constexpr double dear = 1e4; // operations
    const bool is_dear = piece.operations > dear;
    if (rays <= a_handful && !is_dear) return Proofs::most_pieces;
    return rays <= few ? 16 : is_dear ? 2 : 8;
}

int blocks_across(int pixels, int block = shader::proved_block) {
    return (pixels + block - 1) / block;
}

// The numbers of rays for which `is_open` is true of the first of their four numbers.
template<class IsOpen>
std::vector<std::uint32_t> open_among(const OpenRays& rays, const IsOpen& is_open) {
    std::vector<std::uint32_t> open;
    for (std::size_t k = 0; k < rays.pixels.size(); ++k)
        if (is_open(rays.proofs[4 * k])) open.push_back(std::uint32_t(k));
    return open;
}

void write_rays(const OpenRays& rays, int width, std::span<float> record) {
    for (std::size_t k = 0; k < rays.pixels.size(); ++k) {
        const glm::ivec2 pixel = rays.pixels[k];
        const auto at = std::size_t(pixel.y) * std::size_t(width) + std::size_t(pixel.x);
        std::ranges::copy(std::span(rays.proofs).subspan(4 * k, 4), record.subspan(4 * at).begin());
    }
}

void set_thickness(const gpu::Program& program, const RayThickness& thickness) {
    program.set("tube", thickness.tube);
    program.set("shortest_piece", thickness.shortest_piece);
    program.set("most_pieces", Proofs::most_pieces);
}

} // namespace

Proofs::Proofs(const shader::Passes& passes, const scene::OneSurface& one, const MarchPlan& plan,
               bool in_doubles)
    : passes_(passes)
    , drawn_(one)
    , may_take_doubles_(in_doubles)
    , block_pieces_(std::min(
          most_pieces_of_block,
          pieces_of_draw(
              shader::cost_of_block_piece(*one.surface.field, passes, elements_of_piece(passes)),
              double(blocks_across(plan.tile_width)) * blocks_across(plan.tile_height))))
    , natural_{Role::proof, cost_that_fits(cost_of_piece(passes, one, ProofBounds::natural))}
    , of_coarse_blocks_(blocks_across(plan.tile_width, shader::coarse_proved_block),
                        blocks_across(plan.tile_height, shader::coarse_proved_block))
    , of_blocks_(blocks_across(plan.tile_width), blocks_across(plan.tile_height))
    , block_mask_(of_blocks_)
    , frame_(sizeof(FrameBlock))
    , packed_(plan.tile_width, plan.tile_height) {}

void Proofs::upload(PassTable& table, const ProofRays& rays) {
    frame_.update(std::as_bytes(std::span(&rays.frame, 1)));
    table.bind("ProofFrame", frame_);
    const auto set_blocks = [&](Role role, const glm::vec4& beam) {
        const gpu::Program& blocks = table.program(role);
        blocks.set("beam", beam);
        blocks.set("block_pieces", block_pieces_);
    };
    set_blocks(Role::block_proof, rays.beam);
    if (passes_.has(Role::coarse_block_proof))
        set_blocks(Role::coarse_block_proof, rays.coarse_beam);
    for (const Role role :
         {Role::coarse_block_proof, Role::block_proof, Role::first_proof, Role::proof}) {
        if (passes_.has(role)) set_thickness(table.program(role), rays.of_floats);
    }
}

void Proofs::prove_blocks(PassTable& table, const gpu::Rectangle& tile) {
    const auto draw_blocks = [&](Role role, int block) {
        table.draw(table.program(role), {tile.x, tile.y, blocks_across(tile.width, block),
                                         blocks_across(tile.height, block)});
    };
    if (passes_.has(Role::coarse_block_proof)) {
        of_coarse_blocks_.bind();
        draw_blocks(Role::coarse_block_proof, shader::coarse_proved_block);
        table.bind("coarse_block_texture", of_coarse_blocks_.texture(0));
    }
    const auto prove = [&] { draw_blocks(Role::block_proof, shader::proved_block); };
    if (passes_.has(Role::block_mask)) {
        block_mask_.set_and_paint(of_blocks_,
                                  [&] { draw_blocks(Role::block_mask, shader::proved_block); });
        block_mask_.apply(prove);
    } else {
        of_blocks_.bind();
        prove();
    }
    const int across = blocks_across(tile.width), up = blocks_across(tile.height);
    blocks_.resize(4 * std::size_t(across) * std::size_t(up));
    of_blocks_.read(0, 0, 0, across, up, blocks_);
}

void Proofs::prove_rays(PassTable& table, const Pieces& by, const RayThickness& thickness,
                        bool again, std::vector<std::uint32_t> open, OpenRays& rays,
                        const gpu::Rectangle& tile) {
    const gpu::Program& program = table.program(by.role);
    set_thickness(program, thickness);
    // A ray that had all its pieces has nothing to prove. Where elements are found by place a pass
    // may end after any piece.
    const bool by_place = shader::array_with_grid(passes_).has_value();
    for (int left = most_pieces; left > 0 && !open.empty(); again = false) {
        const auto at_once = std::min(open.size(), std::size_t(PackedRays::most));
        const int pieces = std::min(pieces_of_draw(by.cost, double(at_once)),
                                    pieces_of_packing(by.cost, open.size()));
        program.set("pieces_per_pass", pieces);
        program.set("again", int(again));
        packed_.go_on(table, program, tile, open, rays);
        left -= by_place ? 1 : pieces;
        std::erase_if(open, [&](std::uint32_t k) { return rays.proofs[4 * k] >= 0; });
    }
}

const std::optional<Proofs::Pieces>& Proofs::closer_pieces(const PassTable& table) {
    if (!closer_) {
        const bool in_doubles = may_take_doubles_ && table.has(Role::double_proof) &&
                                can_trust_doubles(table.spare_unit());
        const auto bounds = in_doubles ? ProofBounds::in_doubles : ProofBounds::by_gradient;
        const formula::Cost piece = cost_of_piece(passes_, drawn_, bounds);
        closer_.emplace();
        if (fits_a_shader(piece)) {
            *closer_ = Pieces{in_doubles ? Role::double_proof : Role::sharp_proof, piece};
        }
    }
    return *closer_;
}

bool Proofs::floats_decide(PassTable& table, const ProofRays& rays, OpenRays& open,
                           const gpu::Rectangle& tile) {
    constexpr std::size_t worth_asking = 8192, part = 16;
    constexpr double most_in_vain = 0.8;
    std::vector<std::uint32_t> some = open_among(open, [](float outcome) { return outcome < 0; });
    if (some.size() < worth_asking) return true;
    for (std::size_t k = 0; part * k < some.size(); ++k) some[k] = some[part * k];
    some.resize((some.size() + part - 1) / part);
    prove_rays(table, natural_, rays.of_floats, false, some, open, tile);
    const auto in_vain = std::ranges::count_if(some, [&](std::uint32_t k) {
        return open.proofs[4 * std::size_t(k)] >= float(Proof::hidden);
    });
    if (double(in_vain) <= most_in_vain * double(some.size())) return true;
    const std::optional<Pieces>& closer = closer_pieces(table);
    return !closer || closer->role != Role::double_proof;
}

ProofCounts Proofs::prove(PassTable& table, const ProofRays& rays, const gpu::Texture& endings,
                          const gpu::Rectangle& tile, std::span<float> record) {
    if (!rays.in_range) {
        std::ranges::fill(record, float(Proof::none));
        ProofCounts counts{};
        counts[std::size_t(Proof::none)] = std::int64_t(tile.width) * tile.height;
        return counts;
    }
    upload(table, rays);
    table.bind("ending_texture", endings);
    table.bind("block_texture", of_blocks_.texture(0));
    prove_blocks(table, tile);
    const ProvedBlocks blocks = proved_blocks(blocks_, tile.width, tile.height);
    if (!record.empty()) write_proved_blocks(blocks_, tile.width, tile.height, record);
    ProofCounts counts = blocks.decided;
    if (blocks.open.empty()) return counts;

    OpenRays open = packed_.begin(table, table.program(Role::first_proof), tile, blocks.open);
    const auto is_unfinished = [](float outcome) { return outcome < 0; };
    if (floats_decide(table, rays, open, tile)) {
        prove_rays(table, natural_, rays.of_floats, false, open_among(open, is_unfinished), open,
                   tile);
    }
    std::vector<std::uint32_t> undecided = open_among(open, [&](float outcome) {
        return is_unfinished(outcome) || outcome >= float(Proof::hidden);
    });
    if (!undecided.empty()) {
        if (const std::optional<Pieces>& closer = closer_pieces(table)) {
            const bool in_doubles = closer->role == Role::double_proof;
            prove_rays(table, *closer, in_doubles ? rays.of_doubles : rays.of_floats, true,
                       std::move(undecided), open, tile);
        }
    }
    const ProofCounts of_rays = count_proofs(open.proofs);
    for (std::size_t k = 0; k < counts.size(); ++k) counts[k] += of_rays[k];
    if (!record.empty()) write_rays(open, tile.width, record);
    return counts;
}

} // namespace isomotion::render
