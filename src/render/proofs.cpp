#include "render/proofs.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

#include "render/doubles.h"
#include "render/open_squares.h"
#include "render/scene_plan.h"
#include "synthesis/proof_text.h"

namespace isomotion::render {
namespace {

using synthesis::ProofBounds, synthesis::Role;

// Elements that a piece goes through.
std::vector<int> elements_of_piece(const synthesis::Passes& passes) {
    std::vector<int> counts = elements_by_place(passes);
    if (const auto array = synthesis::array_with_grid(passes)) {
        constexpr int cells = 4; // that a piece meets
        int& elements = counts[std::size_t(*array)];
        elements = std::min(cells * elements, passes.arrays[std::size_t(*array)].capacity);
    }
    return counts;
}

formula::Cost cost_of_piece(const synthesis::Passes& passes, const scene::Scene& scene,
                            ProofBounds bounds) {
    return synthesis::cost_of_piece(*scene.surface.field, passes, bounds,
                                    elements_of_piece(passes));
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

// That one draw may bound on each of so many rays.
int pieces_of_draw(const formula::Cost& piece, double rays) {
    const double by_loops = loop_iterations_per_pass / (1 + piece.iterations);
    const double by_work = operations_per_draw / (rays * (piece.operations + 100));
    return int(std::clamp(std::min(by_work, by_loops), 1.0, double(Proofs::most_pieces)));
}

int blocks_across(int pixels, int block = synthesis::proved_block) {
    return (pixels + block - 1) / block;
}

} // namespace

// Lanes of ints, which loops vectorise; few enough at a time that these hold the counts.
ProofCounts count_proofs(std::span<const float> record) {
    constexpr std::size_t at_a_time = 4 * 4096;
    ProofCounts counts{};
    for (std::size_t begin = 0; begin < record.size(); begin += at_a_time) {
        const auto part = record.subspan(begin, std::min(at_a_time, record.size() - begin));
        std::array<int, proof_names.size()> of_part{};
        for (std::size_t k = 0; k < part.size(); k += 4) {
            for (std::size_t proof = 0; proof < of_part.size(); ++proof)
                of_part[proof] += part[k] == float(proof);
        }
        for (std::size_t proof = 0; proof < counts.size(); ++proof) counts[proof] += of_part[proof];
    }
    // What is no outcome proves nothing.
    const auto counted = std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
    counts[std::size_t(Proof::none)] += std::int64_t(record.size() / 4) - counted;
    return counts;
}

double proved_part(const ProofCounts& counts) {
    const auto all = std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
    const auto proved = counts[std::size_t(Proof::hit)] + counts[std::size_t(Proof::miss)];
    return all > 0 ? double(proved) / double(all) : 0;
}

std::string summary(const ProofCounts& counts) {
    const auto all = double(std::accumulate(counts.begin(), counts.end(), std::int64_t{0}));
    std::string text = fmt::format("proved {:.2f} %", 100 * proved_part(counts));
    const char* before = "; not proved: ";
    for (std::size_t k = 0; k < counts.size(); ++k) {
        if (is_proved(Proof(k)) || counts[k] == 0) continue;
        text += fmt::format("{}{:.2f} % {}", before, 100 * double(counts[k]) / all, proof_names[k]);
        before = ", ";
    }
    return text;
}

Proofs::Proofs(const synthesis::Passes& passes, const scene::Scene& scene, const MarchPlan& plan,
               const gpu::DepthMask* mask, bool in_doubles)
    : passes_(passes)
    , scene_(scene)
    , may_take_doubles_(in_doubles)
    , block_pieces_(std::min(
          most_pieces_of_block,
          pieces_of_draw(
              synthesis::cost_of_block_piece(*scene.surface.field, elements_of_piece(passes)),
              double(blocks_across(plan.tile_width)) * blocks_across(plan.tile_height))))
    , natural_{Role::proof, cost_that_fits(cost_of_piece(passes, scene, ProofBounds::natural))}
    , of_coarse_blocks_(blocks_across(plan.tile_width, synthesis::coarse_proved_block),
                        blocks_across(plan.tile_height, synthesis::coarse_proved_block))
    , of_blocks_(blocks_across(plan.tile_width), blocks_across(plan.tile_height))
    , kept_(plan.tile_width, plan.tile_height)
    , going_on_(plan.tile_width, plan.tile_height)
    , mask_(mask ? *mask : own_mask_.emplace(going_on_))
    , frame_(sizeof(FrameBlock)) {
    for (const gpu::Target* target : {&kept_, &going_on_}) mask_.serve(*target);
}

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
    const auto set = [&](Role role, const RayThickness& thickness) {
        const gpu::Program& program = table.program(role);
        program.set("tube", thickness.tube);
        program.set("shortest_piece", thickness.shortest_piece);
        program.set("most_pieces", most_pieces);
    };
    for (const Role role :
         {Role::coarse_block_proof, Role::block_proof, Role::first_proof, Role::proof}) {
        if (passes_.has(role)) set(role, rays.of_floats);
    }
    if (!closer_ || !*closer_) return;
    const Role role = (*closer_)->role;
    set(role, role == Role::double_proof ? rays.of_doubles : rays.of_floats);
}

void Proofs::draw_and_keep(PassTable& table, const gpu::Program& program,
                           const gpu::Rectangle& tile) {
    // A texture can't be read and written at once.
    table.bind("proof_texture", kept_.texture(0));
    mask_.apply(going_on_, [&] { table.draw(program, tile, open_); });
    table.bind("proof_texture", going_on_.texture(0));
    mask_.apply(kept_, [&] { table.draw(table.program(Role::proof_copy), tile, open_); });
}

void Proofs::begin(PassTable& table, const gpu::Rectangle& tile) {
    const auto draw_blocks = [&](Role role, int block, const gpu::Target& into) {
        table.draw(
            table.program(role),
            {tile.x, tile.y, blocks_across(tile.width, block), blocks_across(tile.height, block)},
            into);
    };
    if (passes_.has(Role::coarse_block_proof)) {
        draw_blocks(Role::coarse_block_proof, synthesis::coarse_proved_block, of_coarse_blocks_);
        table.bind("coarse_block_texture", of_coarse_blocks_.texture(0));
    }
    draw_blocks(Role::block_proof, synthesis::proved_block, of_blocks_);
    mask_.apply(kept_, [&] { table.draw(table.program(Role::first_proof), tile); });
}

std::uint32_t Proofs::take_finished_off(PassTable& table, const gpu::Rectangle& tile) {
    table.bind("proof_texture", kept_.texture(0));
    finished_.begin();
    mask_.remove(going_on_, [&] { table.draw(table.program(Role::proof_unmask), tile, open_); });
    finished_.end();
    return finished_.passed();
}

void Proofs::prove_rays(PassTable& table, const Pieces& by, Start start, const OpenSquares& open,
                        const gpu::Rectangle& tile) {
    if (open.pixels == 0) return;
    open_.set(open.areas);
    const gpu::Program& program = table.program(by.role);
    const gpu::Program& gate = table.program(Role::proof_open);
    gate.set("start", int(start));
    table.bind("proof_texture", kept_.texture(0));
    mask_.set(going_on_, [&] { table.draw(gate, tile, open_); });
    // A ray that had all its pieces has nothing to prove. Where elements are found by place a pass
    // may end after any piece.
    const bool by_place = synthesis::array_with_grid(passes_).has_value();
    auto rays = std::uint32_t(open.pixels);
    for (int left = most_pieces; rays > 0; start = Start::go_on) {
        const int pieces = pieces_of_draw(by.cost, rays);
        program.set("pieces_per_pass", pieces);
        program.set("start", int(start));
        draw_and_keep(table, program, tile);
        left -= by_place ? 1 : pieces;
        if (left <= 0) return;
        rays -= std::min(take_finished_off(table, tile), rays);
    }
}

const std::optional<Proofs::Pieces>& Proofs::closer(const PassTable& table) {
    if (!closer_) {
        const bool in_doubles = may_take_doubles_ && can_trust_doubles(table.spare_unit());
        const auto bounds = in_doubles ? ProofBounds::in_doubles : ProofBounds::by_gradient;
        const formula::Cost piece = cost_of_piece(passes_, scene_, bounds);
        closer_.emplace();
        if (fits_a_shader(piece)) {
            *closer_ = Pieces{in_doubles ? Role::double_proof : Role::sharp_proof, piece};
        }
    }
    return *closer_;
}

void Proofs::prove(PassTable& table, const ProofRays& rays, const gpu::Texture& endings,
                   bool is_masked, const gpu::Rectangle& tile, std::span<float> record) {
    if (!rays.in_range) {
        std::ranges::fill(record, float(Proof::none));
        return;
    }
    upload(table, rays);
    table.bind("ending_texture", endings);
    table.bind("block_texture", of_blocks_.texture(0));
    kept_.clear(0, glm::vec4(float(Proof::miss), 0, 0, 0));
    if (!is_masked) {
        mask_.set(kept_, [&] { table.draw(table.program(Role::proof_mask), tile); });
    }
    begin(table, tile);
    // What of the tile is open, by the first number of each pixel.
    const auto read_where = [&](const auto& is_open) {
        kept_.read(0, 0, 0, tile.width, tile.height, record);
        return open_squares(record, tile.width, tile.height, is_open);
    };
    const OpenSquares unfinished = read_where([](float outcome) { return outcome < 0; });
    prove_rays(table, natural_, Start::go_on, unfinished, tile);
    const OpenSquares undecided =
        read_where([](float outcome) { return outcome >= float(Proof::hidden); });
    if (undecided.pixels == 0) return;
    const bool is_first = !closer_;
    const std::optional<Pieces>& again = closer(table);
    if (!again) return;
    if (is_first) upload(table, rays);
    prove_rays(table, *again, Start::again, undecided, tile);
    kept_.read(0, 0, 0, tile.width, tile.height, record);
}

} // namespace isomotion::render
