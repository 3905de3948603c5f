#include "render/proofs_of_surfaces.h"

#include <algorithm>

#include "scene/nth_surface.h"
#include "scene/rays.h"

namespace isomotion::render {
namespace {

using synthesis::Channel, synthesis::Role;

// What the way from t on this surface's ray to t on the first one's and back may round: distances
// from the eye and between the planes where t is 0, some ten times each at most
// (shaders/surfaces/eye_way.glsl, shaders/proof/ending_of_surface.frag).
double rounding_of_way(const scene::SceneAt& own, const scene::SceneAt& first, int width,
                       int height, const scene::Aim& aim) {
    const auto longest = [&](const scene::SceneAt& surface) {
        const scene::Rays rays = scene::rays(surface, width, height, aim);
        return glm::length(rays.axis) + glm::length(rays.right) + glm::length(rays.up) +
               2 * surface.surface.bounds.radius;
    };
    const double unit = first.surface.placement.scale / own.surface.placement.scale;
    return 0x1p-19 * (longest(own) + unit * longest(first));
}

} // namespace

void see_others(PictureInputs& inputs, const scene::SceneAt& now, const scene::Aim& aim) {
    const std::size_t count = scene::surface_count(now);
    const auto surface = [&](std::size_t k) -> const scene::SceneAt& {
        return scene::nth_surface(now, k);
    };
    const auto rays = [&](std::size_t k) -> ProofRays& {
        return *scene::nth_surface(inputs, k).proofs;
    };
    // In the world: how far a proved root may be from where it was found, and the largest rounding.
    double root = 0, most = 0;
    std::vector<double> roundings;
    for (std::size_t k = 0; k < count; ++k) {
        const double scale = surface(k).surface.placement.scale;
        // The first one's t stays to the bit.
        roundings.push_back(
            k == 0 ? 0 : rounding_of_way(surface(k), now, inputs.width, inputs.height, aim));
        root = std::max(root, scale * double(rays(k).of_floats.tube.w));
        most = std::max(most, scale * roundings.back());
    }
    for (std::size_t k = 0; k < count; ++k) {
        ProofRays& own = rays(k);
        const double behind = (root + 2 * most) / surface(k).surface.placement.scale;
        own.beyond = float(1.0001 * (behind + 4 * double(own.of_floats.tube.z)));
        for (RayThickness* thickness : {&own.of_floats, &own.of_doubles})
            thickness->tube.w = std::max(thickness->tube.w - float(1.0001 * roundings[k]), 0.0f);
    }
}

ProofsOfSurfaces::ProofsOfSurfaces(std::vector<SurfacePasses*> all, bool in_doubles)
    : all_(std::move(all))
    , endings_(all_.front()->plan.march.tile_width, all_.front()->plan.march.tile_height) {
    for (SurfacePasses* one : all_) {
        proofs_.push_back(
            std::make_unique<Proofs>(one->passes, one->scene, one->plan.march, in_doubles));
    }
}

ProofCounts ProofsOfSurfaces::prove(const PictureInputs& inputs, const gpu::Target& picture,
                                    const gpu::Rectangle& tile, std::span<float> record) {
    of_one_.resize(record.size());
    for (std::size_t k = 0; k < all_.size(); ++k) {
        SurfacePasses& one = *all_[k];
        const ProofRays& rays = *scene::nth_surface(inputs, k).proofs;
        const synthesis::Passes& passes = one.passes;
        one.bind();
        if (one.beams) one.beams->bind(one.table);
        one.table.bind("way_to_end", picture.texture(*passes.attachment(Channel::ending)));
        one.table.bind("surface_of_end", picture.texture(*passes.attachment(Channel::surface)));
        const gpu::Program& ending = one.table.program(Role::ending);
        ending.set("beyond", rays.beyond);
        one.table.draw(ending, tile, endings_);
        const std::span<float> outcomes = k == 0 ? record : std::span<float>(of_one_);
        proofs_[k]->prove(one.table, rays, endings_.texture(0), tile, outcomes);
        if (k > 0) join_proofs(record, of_one_);
    }
    return count_proofs(record);
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
