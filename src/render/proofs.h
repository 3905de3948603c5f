// Proves, pixel by pixel, that the march found the first root of a ray, or that there is none.
//
// Passes after the march bound F and dF/dt over pieces of rays in float32 interval arithmetic
// (shaders/proof/prove.glsl), first for blocks of rays, then for single rays. Undecided rays are
// tried again with tighter bounds, in doubles where the driver's can be trusted (doubles.h). Each
// ray is thickened by everything that float32 may have made of it, see scene/ray_rounding.h. So a
// proof holds for the ray that was drawn, on any driver. A proved hit is a simple root, the ray's
// first, within an eighth of a pixel's width of the place that was found.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/depth_mask.h"
#include "gpu/query.h"
#include "gpu/rectangles.h"
#include "gpu/target.h"
#include "render/march_plan.h"
#include "render/open_squares.h"
#include "render/pass_table.h"
#include "render/proof_rays.h"

namespace isomotion::render {

// The codes of the channel proof.
enum class Proof {
    none, // the march ended with neither a root nor a miss, or rays are beyond the range of float32
    hit,  // proved
    miss, // proved
    hidden,    // there may be a root before the one found, or on a ray without one
    sign,      // F may not change its sign where the root was found, or more than once
    budget,    // too many pieces
    unbounded, // F or its slope is unbounded on some piece
};
inline constexpr std::array<std::string_view, 7> proof_names{
    "not looked at", "hit", "miss", "may be hidden", "sign undecided", "budget", "unbounded"};
using ProofCounts = std::array<std::int64_t, proof_names.size()>; // of pixels, by Proof

// Of outcomes of four numbers each, the first of which is a Proof.
ProofCounts count_proofs(std::span<const float> record);
constexpr bool is_proved(Proof proof) { return proof == Proof::hit || proof == Proof::miss; }
double proved_part(const ProofCounts& counts); // 0 to 1
// "proved 99.3 %; not proved: 0.5 % sign undecided, 0.2 % may be hidden"
std::string summary(const ProofCounts& counts);

class Proofs {
public:
    // The number of pieces after which a ray's proof is given up.
    static constexpr int most_pieces = 128;
    // The same for a block. Proofs of its single rays continue.
    static constexpr int most_pieces_of_block = 24;

    // Passes and scene must outlive it. `mask`: the pixels that the picture's draw marched, or
    // null. `in_doubles`: undecided rays may be tried again in doubles, if the driver's can be
    // trusted. Throws std::length_error if the formula sums too many terms for a shader.
    Proofs(const synthesis::Passes& passes, const scene::Scene& scene, const MarchPlan& plan,
           const gpu::DepthMask* mask, bool in_doubles);

    // Proves the rays of a tile whose picture is drawn. `endings`: shaders/proof/ending.glsl.
    // `record` receives four floats per pixel, rows from the bottom: Proof, the t down to which the
    // ray is settled, and two more. `is_masked`: the mask is as the picture's draw left it.
    void prove(PassTable& table, const ProofRays& rays, const gpu::Texture& endings, bool is_masked,
               const gpu::Rectangle& tile, std::span<float> record);

private:
    enum class Start { go_on, again };
    // A pass of single rays' proofs, with the cost of a piece.
    struct Pieces {
        synthesis::Role role;
        formula::Cost cost;
    };
    void upload(PassTable& table, const ProofRays& rays);
    // The pass that tries undecided rays again; none if its sums are too long for a shader.
    const std::optional<Pieces>& closer(const PassTable& table);
    // Continues the kept proofs of rays in the mask.
    void draw_and_keep(PassTable& table, const gpu::Program& program, const gpu::Rectangle& tile);
    // Begins with blocks of rays, then with the single rays in the mask.
    void begin(PassTable& table, const gpu::Rectangle& tile);
    // Removes rays whose proofs have ended from the mask; returns their number.
    std::uint32_t take_finished_off(PassTable& table, const gpu::Rectangle& tile);
    // Draws passes until the proofs that are open are finished.
    void prove_rays(PassTable& table, const Pieces& by, Start start, const OpenSquares& open,
                    const gpu::Rectangle& tile);

    const synthesis::Passes& passes_;
    const scene::Scene& scene_;
    bool may_take_doubles_;
    int block_pieces_; // limit on pieces
    Pieces natural_;
    std::optional<std::optional<Pieces>> closer_; // set once it was needed
    gpu::Target of_coarse_blocks_, of_blocks_, kept_, going_on_;
    std::optional<gpu::DepthMask> own_mask_;
    const gpu::DepthMask& mask_; // for the last two targets
    gpu::UniformBuffer frame_;
    gpu::Rectangles open_;       // what passes of single rays are drawn over
    gpu::SamplesQuery finished_; // counts rays
};

} // namespace isomotion::render
