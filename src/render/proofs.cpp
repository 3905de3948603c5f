#include "render/proofs.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "render/doubles.h"
#include "render/proved_blocks.h"
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

// The pieces that one draw may bound on each of so many rays.
int pieces_of_draw(const formula::Cost& piece, double rays) {
    const double by_loops = loop_iterations_per_pass / (1 + piece.iterations);
    const double by_work = operations_per_draw / (rays * (piece.operations + 100));
    return int(std::clamp(std::min(by_work, by_loops), 1.0, double(Proofs::most_pieces)));
}

// The same of a draw that bounds F at the roots first, which takes no more terms than a piece; it
// may be none.
int pieces_after_beginning(const formula::Cost& piece, double rays) {
    const double by_loops = loop_iterations_per_pass / (1 + piece.iterations) - 1;
    const int pieces = pieces_of_draw(piece, rays);
    return piece.iterations > 0 ? std::min(pieces, int(by_loops)) : pieces;
}

int blocks_across(int pixels, int block = synthesis::proved_block) {
    return (pixels + block - 1) / block;
}

gpu::Rectangle around(std::span<const gpu::Rectangle> areas) {
    gpu::Rectangle all = areas.front();
    int right = 0, top = 0;
    for (const gpu::Rectangle& area : areas) {
        all.x = std::min(all.x, area.x);
        all.y = std::min(all.y, area.y);
        right = std::max(right, area.x + area.width);
        top = std::max(top, area.y + area.height);
    }
    all.width = right - all.x;
    all.height = top - all.y;
    return all;
}

// Replaces areas of a record of so many pixels a row.
void write_areas(std::span<const gpu::Rectangle> areas, std::span<const float> texels, int width,
                 std::span<float> record) {
    for (const gpu::Rectangle& area : areas) {
        for (int y = area.y; y < area.y + area.height; ++y) {
            const auto row = texels.first(4 * std::size_t(area.width));
            const std::size_t begin =
                4 * (std::size_t(y) * std::size_t(width) + std::size_t(area.x));
            std::ranges::copy(row, record.subspan(begin).begin());
            texels = texels.subspan(row.size());
        }
    }
}

void set_thickness(const gpu::Program& program, const RayThickness& thickness) {
    program.set("tube", thickness.tube);
    program.set("shortest_piece", thickness.shortest_piece);
    program.set("most_pieces", Proofs::most_pieces);
}

} // namespace

Proofs::Proofs(const synthesis::Passes& passes, const scene::Scene& scene, const MarchPlan& plan,
               bool in_doubles)
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
    , block_mask_(of_blocks_)
    , mask_(going_on_)
    , frame_(sizeof(FrameBlock)) {
    mask_.serve(kept_);
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
        draw_blocks(Role::coarse_block_proof, synthesis::coarse_proved_block);
        table.bind("coarse_block_texture", of_coarse_blocks_.texture(0));
    }
    const auto prove = [&] { draw_blocks(Role::block_proof, synthesis::proved_block); };
    if (passes_.has(Role::block_mask)) {
        block_mask_.set_and_paint(of_blocks_,
                                  [&] { draw_blocks(Role::block_mask, synthesis::proved_block); });
        block_mask_.apply(prove);
    } else {
        of_blocks_.bind();
        prove();
    }
    const int across = blocks_across(tile.width), up = blocks_across(tile.height);
    blocks_.resize(4 * std::size_t(across) * std::size_t(up));
    of_blocks_.read(0, 0, 0, across, up, blocks_);
}

void Proofs::begin(PassTable& table, const ProvedBlocks& blocks, const gpu::Rectangle& tile) {
    mask_.close();
    // A texture can't be read and written at once.
    table.bind("proof_texture", going_on_.texture(0));
    if (!blocks.monotone.areas.empty()) {
        open_.set(blocks.monotone.areas);
        mask_.set(kept_, [&] { table.draw(table.program(Role::monotone_mask), tile, open_); });
        mask_.apply(kept_, [&] { table.draw(table.program(Role::first_proof), tile, open_); });
    }
    table.bind("proof_texture", kept_.texture(0));
    open_.set(blocks.left.areas);
    mask_.set(going_on_, [&] { table.draw(table.program(Role::ray_mask), tile, open_); });
    table.bind("proof_texture", going_on_.texture(0));
    const gpu::Program& program = table.program(Role::proof);
    program.set("pieces_per_pass", pieces_after_beginning(natural_.cost, blocks.left.pixels));
    program.set("start", int(Start::begin));
    PackedRays::unpack(program);
    // Software renderers run the shader twice for pixels where two triangles meet, as those of each
    // square do.
    mask_.apply(kept_, [&] { table.draw(program, tile); });
}

void Proofs::read(const Areas& areas, const gpu::Rectangle& tile) {
    read_kept(areas);
    write_proved_blocks(blocks_, tile.width, areas, texels_);
}

void Proofs::read_kept(const Areas& areas) {
    const auto floats_of = [](const gpu::Rectangle& area) {
        return 4 * std::size_t(area.width) * std::size_t(area.height);
    };
    std::size_t floats = 0;
    for (const gpu::Rectangle& area : areas) floats += floats_of(area);
    texels_.resize(floats);
    std::span<float> to(texels_);
    // Each read waits for a graphics card.
    constexpr std::size_t most_reads = 64;
    if (areas.size() > most_reads) {
        const gpu::Rectangle all = around(areas);
        around_.resize(floats_of(all));
        kept_.read(0, all.x, all.y, all.width, all.height, around_);
        for (const gpu::Rectangle& area : areas) {
            for (int y = area.y; y < area.y + area.height; ++y) {
                const auto row = 4 * (std::size_t(y - all.y) * std::size_t(all.width) +
                                      std::size_t(area.x - all.x));
                const auto texels = std::span(around_).subspan(row, 4 * std::size_t(area.width));
                std::ranges::copy(texels, to.begin());
                to = to.subspan(texels.size());
            }
        }
        return;
    }
    for (const gpu::Rectangle& area : areas) {
        kept_.read(0, area.x, area.y, area.width, area.height, to.first(floats_of(area)));
        to = to.subspan(floats_of(area));
    }
}

void Proofs::prove_rays(PassTable& table, const Pieces& by, const RayThickness& thickness,
                        Start start, std::vector<OpenRay> rays, const gpu::Rectangle& tile) {
    const gpu::Program& program = table.program(by.role);
    set_thickness(program, thickness);
    // A ray that had all its pieces has nothing to prove. Where elements are found by place a pass
    // may end after any piece.
    const bool by_place = synthesis::array_with_grid(passes_).has_value();
    for (int left = most_pieces; left > 0 && !rays.empty(); start = Start::go_on) {
        const std::size_t at_once = std::min<std::size_t>(rays.size(), PackedRays::most);
        const int pieces = pieces_of_draw(by.cost, double(at_once));
        program.set("pieces_per_pass", pieces);
        program.set("start", int(start));
        for (std::size_t first = 0; first < rays.size(); first += at_once) {
            const std::size_t count = std::min(at_once, rays.size() - first);
            packed_.draw(table, program, tile, std::span(rays).subspan(first, count), texels_);
        }
        left -= by_place ? 1 : pieces;
        std::erase_if(rays, [&](const OpenRay& ray) { return texels_[ray.proof] >= 0; });
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
    const Areas& areas = blocks.left.areas;
    ProofCounts counts = blocks.outside;
    if (areas.empty()) return counts;

    begin(table, blocks, tile);
    read(areas, tile);
    prove_rays(table, natural_, rays.of_floats, Start::go_on,
               open_rays(areas, texels_, [](float outcome) { return outcome < 0; }), tile);
    std::vector<OpenRay> undecided =
        open_rays(areas, texels_, [](float outcome) { return outcome >= float(Proof::hidden); });
    if (!undecided.empty()) {
        if (const std::optional<Pieces>& again = closer(table)) {
            const bool in_doubles = again->role == Role::double_proof;
            prove_rays(table, *again, in_doubles ? rays.of_doubles : rays.of_floats, Start::again,
                       std::move(undecided), tile);
        }
    }
    const ProofCounts in_areas = count_proofs(texels_);
    for (std::size_t k = 0; k < counts.size(); ++k) counts[k] += in_areas[k];
    if (!record.empty()) write_areas(areas, texels_, tile.width, record);
    return counts;
}

} // namespace isomotion::render
