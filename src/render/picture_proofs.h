// Proves pictures: of the surface that is seen, that the root is its ray's first; of each other
// one, that the ray meets nothing of it up to there. A proof then tells of all surfaces what
// proofs.h tells of one.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "gpu/target.h"
#include "render/proofs.h"
#include "render/surface_passes.h"

namespace isomotion::render {

// Adjusts the rays of each of several surfaces' proofs to the others'. The place of a root comes
// from the first surface's ray to another one's with a rounding, which both have to bear.
void see_others(PictureInputs& inputs, const scene::SceneAt& now, const scene::Aim& aim);

class PictureProofs {
public:
    // `all` must outlive it.
    PictureProofs(std::vector<SurfacePasses*> all, bool in_doubles);

    // Does for all surfaces what Proofs::prove does. `keeps`: record() has the outcomes then.
    ProofCounts prove(const PictureInputs& inputs, const gpu::Target& picture,
                      const gpu::Rectangle& tile, bool keeps);
    // The outcomes of the tile proved last, as Proofs::prove writes them.
    const std::vector<float>& record() const { return record_; }

private:
    // Proves one surface's rays of a tile into `outcomes`.
    ProofCounts prove_surface(std::size_t k, const PictureInputs& inputs,
                              const gpu::Target& picture, const gpu::Rectangle& tile,
                              std::span<float> outcomes);

    std::vector<SurfacePasses*> all_;
    std::vector<std::unique_ptr<Proofs>> proofs_;
    std::optional<gpu::Target> endings_; // on one of several surfaces
    std::vector<float> record_, of_one_;
};

// Adds a surface's outcomes to those of surfaces before it: proved is what is proved of all.
void join_proofs(std::span<float> all, std::span<const float> of_one);

} // namespace isomotion::render
