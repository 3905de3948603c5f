#include "render/proofs.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

#include "render/blocks.h"
#include "synthesis/proof_text.h"

namespace isomotion::render {
namespace {

int plan_pieces(const synthesis::Shaders& shaders, const scene::Scene& scene, const MarchPlan& plan,
                synthesis::ProofBounds bounds) {
    std::vector<int> counts;
    for (const auto& array : shaders.arrays) counts.push_back(array.capacity);
    const formula::Cost piece =
        synthesis::cost(*scene.surface.field, synthesis::proof_samples(bounds), counts);
    const double by_loops = loop_iterations_per_pass / (1 + piece.iterations);
    if (by_loops < 1) {
        throw std::length_error(
            fmt::format("a proof bounds {:.0f} terms for every piece; a shader can sum {:.0f}: "
                        "draw fewer elements or without certify",
                        piece.iterations, loop_iterations_per_pass - 1));
    }
    const double pixels = double(plan.tile_width) * plan.tile_height;
    const double by_work = operations_per_draw / (pixels * (piece.operations + 100));
    return int(std::clamp(std::min(by_work, by_loops), 1.0, double(Proofs::most_pieces)));
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
               int first_unit)
    : to_prove_(shaders.vertex, shaders.to_prove, "rays to prove")
    , waiting_(shaders.vertex, shaders.waiting, "waiting proofs")
    , keep_(shaders.vertex, shaders.keep, "proofs that went on")
    , natural_{gpu::Program(shaders.vertex, shaders.proof, "proof"),
               plan_pieces(shaders, scene, plan, synthesis::ProofBounds::natural)}
    , sharp_{gpu::Program(shaders.vertex, shaders.sharp_proof, "sharp proof"),
             plan_pieces(shaders, scene, plan, synthesis::ProofBounds::by_gradient)}
    , ending_(attachment_of(shaders, synthesis::Channel::ending))
    , kept_(plan.tile_width, plan.tile_height)
    , going_on_(plan.tile_width, plan.tile_height)
    , gate_(going_on_)
    , frame_(sizeof(FrameBlock))
    , first_unit_(first_unit) {
    gate_.serve(kept_);
    for (const gpu::Program* program :
         {&to_prove_, &waiting_, &keep_, &natural_.program, &sharp_.program}) {
        program->bind_sampler("proof_texture", first_unit);
        program->bind_sampler("record_texture", first_unit + 1);
        program->bind_sampler("ending_texture", first_unit + 2);
    }
}

void Proofs::for_each_program(const std::function<void(const gpu::Program&)>& visit) const {
    for (const gpu::Program* program : {&to_prove_, &natural_.program, &sharp_.program}) {
        visit(*program);
    }
}

void Proofs::upload(const scene::Scene& scene, const scene::SceneAt& now, int width, int height,
                    const scene::Aim& aim) {
    const scene::Rays rays = scene::rays(now, width, height, aim);
    const double footprint = 2 * glm::length(rays.up) / height;
    // Of truth's tubes what a point may be off by, four times over: the rays here and those marched
    // are each within once that of the exact one.
    const double margin = beam_range(now, width, height, aim, 1).w;
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

void Proofs::draw(const gpu::Program& program) {
    program.set("tile_origin", glm::ivec2(tile_.x, tile_.y));
    gpu::set_viewport({0, 0, tile_.width, tile_.height});
    program.use();
    triangle_.draw();
}

bool Proofs::open(const gpu::Program& program) {
    passes_.begin();
    gate_.open([&] { draw(program); });
    passes_.end();
    return passes_.any_passed();
}

void Proofs::finish(const Pass& pass, Start start) {
    pass.program.set("pieces_per_pass", pass.pieces);
    for (;; start = Start::go_on) {
        kept_.texture(0).bind(first_unit_);
        waiting_.set("start", int(start));
        if (!open(start == Start::begin ? to_prove_ : waiting_)) return;
        // What begins needs nothing of what is kept; what goes on can't be read and written at
        // once.
        const bool begins = start != Start::go_on;
        pass.program.set("start", begins ? 1 : 0);
        if (begins) going_on_.texture(0).bind(first_unit_);
        gate_.through(begins ? kept_ : going_on_, [&] { draw(pass.program); });
        if (begins) continue;
        going_on_.texture(0).bind(first_unit_);
        gate_.through(kept_, [&] { draw(keep_); });
    }
}

void Proofs::prove(const gpu::Target& picture, const gpu::Rectangle& tile, unsigned binding,
                   std::span<float> record) {
    tile_ = tile;
    frame_.bind(binding);
    picture.texture(1).bind(first_unit_ + 1);
    picture.texture(ending_).bind(first_unit_ + 2);
    kept_.clear(0, glm::vec4(float(Proof::miss), 0, 0, 0));
    finish(natural_, Start::begin);
    finish(sharp_, Start::again);
    kept_.read(0, 0, 0, tile.width, tile.height, record);
}

} // namespace isomotion::render
