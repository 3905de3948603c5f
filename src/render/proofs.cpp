#include "render/proofs.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "render/blocks.h"
#include "render/doubles.h"
#include "scene/ray_rounding.h"
#include "synthesis/proof_text.h"

namespace isomotion::render {
namespace {

formula::Cost cost_of_piece(const synthesis::Shaders& shaders, const scene::Scene& scene,
                            const std::vector<synthesis::FieldFunction>& samples) {
    std::vector<int> counts;
    for (const auto& array : shaders.arrays) counts.push_back(array.capacity);
    return synthesis::cost(*scene.surface.field, samples, counts);
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

std::vector<synthesis::FieldFunction> samples_of(const scene::Scene& scene,
                                                 synthesis::ProofBounds bounds) {
    return synthesis::proof_samples(*scene.surface.field, bounds);
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

// Of the outcomes of pixels, four numbers each.
std::uint32_t count_open(std::span<const float> record) {
    std::uint32_t open = 0;
    for (std::size_t k = 0; k < record.size(); k += 4) {
        open += Proof(int(record[k])) >= Proof::hidden;
    }
    return open;
}

// How many times the rounding of points and directions (scene/ray_rounding.h) a proof's boxes are
// wider than its own ray.
struct Roundings {
    double points, directions;
};
// The proof's ray in floats and the marched one are each within once the rounding of the exact one;
// the ends of boxes and of directions are rounded, too.
constexpr Roundings of_two_rays{2.2, 3};
// A ray in doubles is the exact one but for 2^-40 of the rounding; the rest is for its boxes.
constexpr Roundings of_one_ray{1.04, 1.01};

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
               int first_unit, const gpu::Gate* gate, Again again)
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
               cost_that_fits(cost_of_piece(shaders, scene,
                                            samples_of(scene, synthesis::ProofBounds::natural)))}
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
    make_closer_ = [this, &shaders, &scene, again = std::move(again)] {
        const bool in_doubles = again.in_doubles && can_trust_doubles(first_unit_);
        const auto bounds =
            in_doubles ? synthesis::ProofBounds::in_doubles : synthesis::ProofBounds::by_gradient;
        const formula::Cost piece = cost_of_piece(shaders, scene, samples_of(scene, bounds));
        std::optional<Pass> made;
        if (!fits_a_shader(piece)) return made;
        made = Pass{gpu::Program(shaders.vertex,
                                 in_doubles ? shaders.double_proof : shaders.sharp_proof,
                                 in_doubles ? "proof in doubles" : "sharp proof"),
                    piece, in_doubles};
        bind_samplers(made->program);
        again.connect(made->program);
        return made;
    };
}

void Proofs::bind_samplers(const gpu::Program& program) const {
    program.bind_sampler("proof_texture", first_unit_);
    program.bind_sampler("ending_texture", first_unit_ + 1);
    program.bind_sampler("block_texture", first_unit_ + 2);
}

void Proofs::for_each_program(const std::function<void(const gpu::Program&)>& visit) const {
    for (const gpu::Program* program : {&to_prove_, &blocks_, &begin_, &natural_.program}) {
        visit(*program);
    }
    if (closer_) visit(closer_->program);
}

void Proofs::set(const gpu::Program& program, const Thickness& thickness) {
    program.set("tube", thickness.tube);
    program.set("shortest_piece", thickness.shortest_piece);
    program.set("most_pieces", most_pieces);
}

void Proofs::set(const Pass& pass) const {
    set(pass.program, pass.in_doubles ? of_doubles_ : of_floats_);
}

void Proofs::upload(const scene::Scene& scene, const scene::SceneAt& now, int width, int height,
                    const scene::Aim& aim) {
    const scene::Rays rays = scene::rays(now, width, height, aim);
    const double footprint = 2 * glm::length(rays.up) / height;
    const glm::vec4 block_range = beam_range(now, width, height, aim, synthesis::proved_block);
    blocks_.set("beam", block_range);
    blocks_.set("block_pieces", block_pieces_);
    // The ends of a ray's part are off by what its beam's pieces are.
    const double margin = block_range.w, rounding = margin / beam_roundings;
    const double direction = scene::ray_rounding(rays, now.bounds, scene::Norm::length).direction;
    const auto shortest = float(std::max(margin, footprint / 256));
    const auto thickness = [&](const Roundings& times) {
        return Thickness{
            glm::vec4(times.points * rounding, times.directions * direction, margin, footprint / 8),
            shortest};
    };
    of_floats_ = thickness(of_two_rays);
    of_doubles_ = thickness(of_one_ray);
    for (const gpu::Program* program : {&blocks_, &begin_}) set(*program, of_floats_);
    set(natural_);
    if (closer_) set(*closer_);

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

const Proofs::Pass* Proofs::closer() {
    if (make_closer_) {
        closer_ = std::exchange(make_closer_, {})();
        if (closer_) set(*closer_);
    }
    return closer_ ? &*closer_ : nullptr;
}

void Proofs::bind_inputs(const gpu::Target& picture) const {
    picture.texture(ending_).bind(first_unit_ + 1);
    of_blocks_.texture(0).bind(first_unit_ + 2);
}

void Proofs::prove(const gpu::Target& picture, bool is_gated, const gpu::Rectangle& tile,
                   unsigned binding, std::span<float> record) {
    tile_ = tile;
    frame_.bind(binding);
    bind_inputs(picture);
    kept_.clear(0, glm::vec4(float(Proof::miss), 0, 0, 0));
    if (!is_gated) gate_.set(kept_, [&] { draw(to_prove_); });
    begin();
    prove_rays(natural_, Start::go_on, drawn_.passed());
    const auto read = [&] { kept_.read(0, 0, 0, tile.width, tile.height, record); };
    read();
    const std::uint32_t open = count_open(record);
    if (open == 0) return;
    const Pass* again = closer();
    if (!again) return;
    bind_inputs(picture);
    prove_rays(*again, Start::again, open);
    read();
}

} // namespace isomotion::render
