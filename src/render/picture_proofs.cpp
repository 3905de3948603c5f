#include "render/picture_proofs.h"

#include <algorithm>
#include <stdexcept>

#include "scene/rays.h"

namespace isomotion::render {
namespace {

using shader::Channel, shader::Role;

// What the way from t on this surface's ray to t on the first one's and back may round: distances
// from the eye and between the planes where t is 0, some ten times each at most
// (shaders/surfaces/way.glsl, shaders/proof/ending_of_surface.frag).
double rounding_of_way(const scene::OneSurfaceAt& own, const scene::OneSurfaceAt& first, int width,
                       int height, const scene::Aim& aim) {
    const auto longest = [&](const scene::OneSurfaceAt& now) {
        const scene::Rays rays = scene::rays(now, width, height, aim);
        return glm::length(rays.axis) + glm::length(rays.right) + glm::length(rays.up) +
               2 * now.surface.bounds.radius;
    };
    const double unit = first.surface.placement.scale / own.surface.placement.scale;
    return 0x1p-19 * (longest(own) + unit * longest(first));
}

const gpu::Texture& attached(const gpu::Target& picture, const shader::PassPlan& passes,
                             Channel channel) {
    const auto at = passes.attachment(channel);
    if (!at) throw std::logic_error("proofs of a picture without what they are of");
    return picture.texture(*at);
}

} // namespace

void see_others(PictureInputs& inputs, const scene::SceneAt& now, const scene::Aim& aim) {
    // In the world: how far a proved root may be from where it was found, and the largest rounding.
    double root = 0, most = 0;
    std::vector<double> roundings;
    for (std::size_t k = 0; k < now.surfaces.size(); ++k) {
        const double scale = now.surfaces[k].placement.scale;
        // The first one's t stays to the bit.
        roundings.push_back(
            k == 0 ? 0 : rounding_of_way({now, k}, {now, 0}, inputs.width, inputs.height, aim));
        root = std::max(root, scale * double(inputs.surfaces[k].proofs->of_floats.tube.w));
        most = std::max(most, scale * roundings.back());
    }
    for (std::size_t k = 0; k < now.surfaces.size(); ++k) {
        ProofRays& own = *inputs.surfaces[k].proofs;
        const double behind = (root + 2 * most) / now.surfaces[k].placement.scale;
        own.beyond = float(1.0001 * (behind + 4 * double(own.of_floats.tube.z)));
        for (RayThickness* thickness : {&own.of_floats, &own.of_doubles})
            thickness->tube.w = std::max(thickness->tube.w - float(1.0001 * roundings[k]), 0.0f);
    }
}

PictureProofs::PictureProofs(std::vector<SurfacePasses*> all, bool in_doubles)
    : all_(std::move(all)) {
    for (SurfacePasses* one : all_) {
        proofs_.push_back(
            std::make_unique<Proofs>(one->passes, one->drawn, one->plan.march, in_doubles));
    }
    const MarchPlan& tile = all_.front()->plan.march;
    if (all_.size() > 1) endings_.emplace(tile.tile_width, tile.tile_height);
}

ProofCounts PictureProofs::prove_surface(std::size_t k, const PictureInputs& inputs,
                                         const gpu::Target& picture, const gpu::Rectangle& tile,
                                         std::span<float> outcomes) {
    SurfacePasses& one = *all_[k];
    const auto& rays = inputs.surfaces[k].proofs;
    if (!rays) throw std::logic_error("proofs of a surface without rays");
    const gpu::Texture& ended = attached(picture, one.passes, Channel::ending);
    if (!endings_) return proofs_[k]->prove(one.table, *rays, ended, tile, outcomes);
    one.bind();
    if (one.beams) one.beams->bind(one.table);
    one.table.bind("way_to_end", ended);
    one.table.bind("surface_of_end", attached(picture, one.passes, Channel::surface));
    const gpu::Program& ending = one.table.program(Role::ending);
    ending.set("beyond", rays->beyond);
    one.table.draw(ending, tile, *endings_);
    return proofs_[k]->prove(one.table, *rays, endings_->texture(0), tile, outcomes);
}

ProofCounts PictureProofs::prove(const PictureInputs& inputs, const gpu::Target& picture,
                                 const gpu::Rectangle& tile, bool keeps) {
    const bool joins = all_.size() > 1;
    record_.resize(keeps || joins ? std::size_t(tile.width) * std::size_t(tile.height) * 4 : 0);
    const ProofCounts of_first = prove_surface(0, inputs, picture, tile, record_);
    if (!joins) return of_first;
    of_one_.resize(record_.size());
    for (std::size_t k = 1; k < all_.size(); ++k) {
        prove_surface(k, inputs, picture, tile, of_one_);
        join_proofs(record_, of_one_);
    }
    return count_proofs(record_);
}

void join_proofs(std::span<float> all, std::span<const float> of_one) {
    for (std::size_t k = 0; k < all.size(); k += 4) {
        const auto before = Proof(int(all[k])), own = Proof(int(of_one[k]));
        const bool counts = before == Proof::none ? false
                            : own == Proof::none  ? true
                            : !is_proved(before)  ? false
                            : !is_proved(own)     ? true
                                                  : own == Proof::hit;
        if (counts)
            std::copy_n(of_one.begin() + std::ptrdiff_t(k), 4, all.begin() + std::ptrdiff_t(k));
    }
}

} // namespace isomotion::render
