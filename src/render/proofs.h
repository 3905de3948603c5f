// Proves, pixel by pixel, that the march found the first root of a ray, or that there is none.
//
// Passes after the march bound F and dF/dt over pieces of rays in float32 interval arithmetic
// (shaders/proof/prove.glsl), first for blocks of rays, then for the single rays that these leave
// open. Undecided rays are tried again with tighter bounds, in doubles where the driver's can be
// trusted (doubles.h). Each ray is thickened by everything that float32 may have made of it, see
// scene/ray_rounding.h. So a proof holds for the ray that was drawn, on any driver. A proved hit is
// a simple root, the ray's first, within an eighth of a pixel's width of the place that was found.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/depth_mask.h"
#include "gpu/target.h"
#include "render/march_plan.h"
#include "render/packed_rays.h"
#include "render/pass_table.h"
#include "render/proof_outcome.h"
#include "render/proof_rays.h"
#include "render/proved_blocks.h"

namespace isomotion::render {

class Proofs {
public:
    // The number of pieces after which a ray's proof is given up.
    static constexpr int most_pieces = 128;
    // The same for a block. Proofs of its single rays continue.
    static constexpr int most_pieces_of_block = 24;

    // Passes and scene must outlive it. `in_doubles`: undecided rays may be tried again in doubles,
    // if the driver's can be trusted. Throws std::length_error if the formula sums too many terms
    // for a shader.
    Proofs(const shader::Passes& passes, const scene::OneSurface& one, const MarchPlan& plan,
           bool in_doubles);

    // Proves the rays of a tile whose picture is drawn. `endings`: shaders/proof/ending.glsl.
    // Unless it is empty, `record` receives four floats per pixel, rows from the bottom: Proof; of
    // rays that are not proved, the t down to which they are settled; and two more.
    ProofCounts prove(PassTable& table, const ProofRays& rays, const gpu::Texture& endings,
                      const gpu::Rectangle& tile, std::span<float> record);

private:
    // A pass of single rays' proofs, with the cost of a piece.
    struct Pieces {
        shader::Role role;
        formula::Cost cost;
    };
    void upload(PassTable& table, const ProofRays& rays);
    // The pass that tries undecided rays again; none if its sums are too long for a shader.
    const std::optional<Pieces>& closer_pieces(const PassTable& table);
    // Proves blocks of rays, and reads their proofs.
    void prove_blocks(PassTable& table, const gpu::Rectangle& tile);
    // Whether floats decide rays that are open, by some of them, which it proves. If not, doubles
    // are there to try all.
    bool floats_decide(PassTable& table, const ProofRays& rays, OpenRays& open,
                       const gpu::Rectangle& tile);
    // Draws passes until the proofs of those rays that `open` numbers are finished. `again`: these
    // were given up.
    void prove_rays(PassTable& table, const Pieces& by, const RayThickness& thickness, bool again,
                    std::vector<std::uint32_t> open, OpenRays& rays, const gpu::Rectangle& tile);

    const shader::Passes& passes_;
    scene::OneSurface drawn_;
    bool may_take_doubles_;
    int block_pieces_; // limit on pieces
    Pieces natural_;
    std::optional<std::optional<Pieces>> closer_; // set once it was needed
    gpu::Target of_coarse_blocks_, of_blocks_;
    gpu::DepthMask block_mask_;
    gpu::UniformBuffer frame_;
    PackedRays packed_;
    std::vector<float> blocks_; // read last
};

} // namespace isomotion::render
