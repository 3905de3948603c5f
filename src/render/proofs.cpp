#include "render/proofs.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

#include "render/blocks.h"
#include "synthesis/proof_text.h"

namespace isomotion::render {
namespace {

formula::Cost cost_of_piece(const synthesis::Shaders& shaders, const scene::Scene& scene,
                            const std::vector<synthesis::FieldFunction>& samples) {
    std::vector<int> counts;
    for (const auto& array : shaders.arrays) counts.push_back(array.capacity);
    const formula::Cost piece = synthesis::cost(*scene.surface.field, samples, counts);
    if (1 + piece.iterations > loop_iterations_per_pass) {
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

int blocks_across(int pixels) {
    return (pixels + synthesis::proved_block - 1) / synthesis::proved_block;
}

int attachment_of(const synthesis::Shaders& shaders, synthesis::Channel channel) {
    const auto& all = shaders.attachments;
    return 2 + int(std::find(all.begin(), all.end(), channel) - all.begin());
}

} // namespace

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

Proofs::Proofs(const synthesis::Shaders& shaders, const scene::Scene& scene, const MarchPlan& plan,
               int first_unit, const gpu::Gate* gate)
    : block_pieces_(std::min(
          most_pieces_of_block,
          pieces_of_draw(cost_of_piece(shaders, scene, synthesis::block_proof_samples()),
                         double(blocks_across(plan.tile_width)) * blocks_across(plan.tile_height))))
    , to_prove_(shaders.vertex, shaders.to_prove, "rays to prove")
    , close_(shaders.vertex, shaders.close_proofs, "ended proofs")
    , keep_(shaders.vertex, shaders.keep, "proofs that went on")
    , blocks_(shaders.vertex, shaders.block_proof, "proofs of blocks")
    , begin_(shaders.vertex, shaders.begin_proof, "beginning proofs")
    , natural_{gpu::Program(shaders.vertex, shaders.proof, "proof"),
               cost_of_piece(shaders, scene,
                             synthesis::proof_samples(synthesis::ProofBounds::natural))}
    , sharp_{gpu::Program(shaders.vertex, shaders.sharp_proof, "sharp proof"),
             cost_of_piece(shaders, scene,
                           synthesis::proof_samples(synthesis::ProofBounds::by_gradient))}
    , ending_(attachment_of(shaders, synthesis::Channel::ending))
    , of_blocks_(blocks_across(plan.tile_width), blocks_across(plan.tile_height))
    , kept_(plan.tile_width, plan.tile_height)
    , going_on_(plan.tile_width, plan.tile_height)
    , gate_(gate ? *gate : own_gate_.emplace(going_on_))
    , frame_(sizeof(FrameBlock))
    , first_unit_(first_unit) {
    for (const gpu::Target* target : {&kept_, &going_on_}) gate_.serve(*target);
    for_each_program([&](const gpu::Program& program) { bind_samplers(program); });
    for (const gpu::Program* program : {&close_, &keep_}) bind_samplers(*program);
}

void Proofs::bind_samplers(const gpu::Program& program) const {
    program.bind_sampler("proof_texture", first_unit_);
    program.bind_sampler("ending_texture", first_unit_ + 1);
    program.bind_sampler("block_texture", first_unit_ + 2);
}

void Proofs::for_each_program(const std::function<void(const gpu::Program&)>& visit) const {
    for (const gpu::Program* program :
         {&to_prove_, &blocks_, &begin_, &natural_.program, &sharp_.program}) {
        visit(*program);
    }
}

void Proofs::upload(const scene::Scene& scene, const scene::SceneAt& now, int width, int height,
                    const scene::Aim& aim) {
    const scene::Rays rays = scene::rays(now, width, height, aim);
    const double footprint = 2 * glm::length(rays.up) / height;
    // Of truth's tubes what a point may be off by, four times over: the rays here and those marched
    // are each within once that of the exact one.
    const glm::vec4 block_range = beam_range(now, width, height, aim, synthesis::proved_block);
    const double margin = block_range.w;
    blocks_.set("beam", block_range);
    blocks_.set("block_pieces", block_pieces_);
    const double spread = glm::length(rays.right) + glm::length(rays.up);
    const double direction =
        3 * 16 * 0x1p-24 * (1 + (rays.parallel ? 0 : spread / glm::length(rays.axis)));
    for_each_program([&](const gpu::Program& program) {
        program.set("tube", glm::vec4(0.55 * margin, direction, margin, footprint / 8));
        program.set("shortest_piece", float(std::max(margin, footprint / 256)));
        program.set("most_pieces", most_pieces);
    });

    FrameBlock block = frame_block(scene, now, width, height, aim);
    const auto more = float(margin);
    if (now.bounds.shape == scene::Bounds::Shape::sphere) {
        block.bounds_min.w += more;
    } else {
        block.bounds_min -= more;
        block.bounds_max += more;
    }
    frame_.update(std::as_bytes(std::span(&block, 1)));
}

void Proofs::draw(const gpu::Program& program, int width, int height) const {
    program.set("tile_origin", glm::ivec2(tile_.x, tile_.y));
    gpu::set_viewport({0, 0, width, height});
    program.use();
    triangle_.draw();
}

void Proofs::draw(const gpu::Program& program) const { draw(program, tile_.width, tile_.height); }

void Proofs::draw_and_keep(const gpu::Program& program) {
    // A texture can't be read and written at once.
    kept_.texture(0).bind(first_unit_);
    drawn_.begin();
    gate_.through(going_on_, [&] { draw(program); });
    drawn_.end();
    going_on_.texture(0).bind(first_unit_);
    gate_.through(kept_, [&] { draw(keep_); });
}

void Proofs::begin() {
    of_blocks_.bind();
    draw(blocks_, blocks_across(tile_.width), blocks_across(tile_.height));
    of_blocks_.texture(0).bind(first_unit_ + 2);
    draw_and_keep(begin_);
}

void Proofs::prove_rays(const Pass& pass, Start start, std::uint32_t rays) {
    // No more rays have something to prove than in the draw before. A ray that had all its pieces
    // has nothing.
    for (int left = most_pieces; left > 0 && rays > 0; start = Start::go_on) {
        kept_.texture(0).bind(first_unit_);
        gate_.close(going_on_, [&] { draw(close_); });
        const int pieces = pieces_of_draw(pass.piece, rays);
        pass.program.set("pieces_per_pass", pieces);
        pass.program.set("start", int(start));
        draw_and_keep(pass.program);
        left -= pieces;
        if (left > 0) rays = drawn_.passed();
    }
}

void Proofs::prove(const gpu::Target& picture, bool is_gated, const gpu::Rectangle& tile,
                   unsigned binding, std::span<float> record) {
    tile_ = tile;
    frame_.bind(binding);
    picture.texture(ending_).bind(first_unit_ + 1);
    kept_.clear(0, glm::vec4(float(Proof::miss), 0, 0, 0));
    if (!is_gated) gate_.set([&] { draw(to_prove_); });
    begin();
    const std::uint32_t open = drawn_.passed();
    prove_rays(natural_, Start::go_on, open);
    prove_rays(sharp_, Start::again, open);
    kept_.read(0, 0, 0, tile.width, tile.height, record);
}

} // namespace isomotion::render
