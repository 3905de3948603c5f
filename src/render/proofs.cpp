#include "render/proofs.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "render/blocks.h"
#include "render/doubles.h"
#include "synthesis/proof_text.h"

namespace isomotion::render {
namespace {

int plan_pieces(const synthesis::Shaders& shaders, const scene::Scene& scene, const MarchPlan& plan,
                synthesis::ProofBounds bounds) {
    std::vector<int> counts;
    for (const auto& array : shaders.arrays) counts.push_back(array.capacity);
    const formula::Field& field = *scene.surface.field;
    const formula::Cost piece =
        synthesis::cost(field, synthesis::proof_samples(field, bounds), counts);
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

// Of the outcomes of pixels, four numbers each.
bool is_any_open(std::span<const float> record) {
    for (std::size_t k = 0; k < record.size(); k += 4) {
        if (Proof(int(record[k])) >= Proof::hidden) return true;
    }
    return false;
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
               int first_unit, InDoubles in_doubles)
    : natural_{gpu::Program(shaders.vertex, shaders.proof, "proof"),
               plan_pieces(shaders, scene, plan, synthesis::ProofBounds::natural)}
    , sharp_{gpu::Program(shaders.vertex, shaders.sharp_proof, "sharp proof"),
             plan_pieces(shaders, scene, plan, synthesis::ProofBounds::by_gradient)}
    , unfinished_(shaders.vertex, shaders.unfinished, "unfinished proofs")
    , states_(plan.tile_width, plan.tile_height, units)
    , from_(&states_.odd)
    , to_(&states_.even)
    , nowhere_(plan.tile_width, plan.tile_height)
    , frame_(sizeof(FrameBlock))
    , first_unit_(first_unit) {
    for_each_program([&](const gpu::Program& program) { connect_textures(program); });
    connect_textures(unfinished_);
    if (!in_doubles.wanted) return;
    const int pieces = plan_pieces(shaders, scene, plan, synthesis::ProofBounds::in_doubles);
    make_in_doubles_ = [this, &shaders, pieces, connect = std::move(in_doubles.connect)] {
        std::optional<Pass> made;
        if (!can_trust_doubles(first_unit_)) return made;
        made = Pass{gpu::Program(shaders.vertex, shaders.double_proof, "proof in doubles"), pieces};
        connect_textures(made->program);
        connect(made->program);
        return made;
    };
}

void Proofs::connect_textures(const gpu::Program& program) const {
    program.bind_sampler("proof_texture_0", first_unit_);
    program.bind_sampler("proof_texture_1", first_unit_ + 1);
}

void Proofs::for_each_program(const std::function<void(const gpu::Program&)>& visit) const {
    visit(natural_.program);
    visit(sharp_.program);
    if (in_doubles_) visit(in_doubles_->program);
}

void Proofs::set(const Pass& pass, const Thickness& thickness, int most_pieces) {
    pass.program.set("tube", thickness.tube);
    pass.program.set("shortest_piece", thickness.shortest_piece);
    pass.program.set("most_pieces", most_pieces);
}

void Proofs::upload(const scene::Scene& scene, const scene::SceneAt& now, int width, int height,
                    const scene::Aim& aim) {
    const scene::Rays rays = scene::rays(now, width, height, aim);
    const double footprint = 2 * glm::length(rays.up) / height;
    // Of truth's tubes what a point may be off by, four times over: the rays here and those marched
    // are each within once that of the exact one, which the rays in doubles are but for 2^-40 of
    // it.
    const double margin = beam_range(now, width, height, aim, 1).w;
    const double spread = glm::length(rays.right) + glm::length(rays.up);
    const double direction =
        16 * 0x1p-24 * (1 + (rays.parallel ? 0 : spread / glm::length(rays.axis)));
    const auto shortest = float(std::max(margin, footprint / 256));
    const Thickness of_floats{glm::vec4(0.55 * margin, 3 * direction, margin, footprint / 8),
                              shortest};
    of_doubles_ = {glm::vec4(0.26 * margin, 1.01 * direction, margin, footprint / 8), shortest};
    for (const Pass* pass : {&natural_, &sharp_}) set(*pass, of_floats, most_pieces);
    if (in_doubles_) set(*in_doubles_, of_doubles_, most_pieces_in_doubles);

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

void Proofs::finish(const gpu::Rectangle& tile, const Pass& pass, Start start) {
    const glm::ivec2 origin(tile.x, tile.y);
    pass.program.set("tile_origin", origin);
    pass.program.set("pieces_per_pass", pass.pieces);
    for (bool active = true; active; start = Start::go_on) {
        for (int k = 0; k < units; ++k) from_->texture(k).bind(first_unit_ + k);
        pass.program.set("start", int(start));
        to_->bind();
        gpu::set_viewport({0, 0, tile.width, tile.height});
        pass.program.use();
        triangle_.draw();

        to_->texture(0).bind(first_unit_);
        nowhere_.bind();
        unfinished_.use();
        still_active_.begin();
        triangle_.draw();
        still_active_.end();
        active = still_active_.any_passed();
        std::swap(from_, to_);
    }
}

const Proofs::Pass* Proofs::pass_in_doubles() {
    if (make_in_doubles_) {
        in_doubles_ = std::exchange(make_in_doubles_, {})();
        if (in_doubles_) set(*in_doubles_, of_doubles_, most_pieces_in_doubles);
    }
    return in_doubles_ ? &*in_doubles_ : nullptr;
}

void Proofs::prove(const gpu::Rectangle& tile, unsigned binding, std::span<float> record) {
    frame_.bind(binding);
    finish(tile, natural_, Start::begin);
    finish(tile, sharp_, Start::again);
    from_->read(0, 0, 0, tile.width, tile.height, record);
    if (!is_any_open(record)) return;
    const Pass* in_doubles = pass_in_doubles();
    if (!in_doubles) return;
    finish(tile, *in_doubles, Start::resume);
    from_->read(0, 0, 0, tile.width, tile.height, record);
}

} // namespace isomotion::render
