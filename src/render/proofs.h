// Proves, pixel by pixel, that the march found the first root of a ray, or rightly found none.
//
// Passes after the march bound F and dF/dt over pieces of rays in float32 interval arithmetic
// (shaders/proof/prove.glsl), of blocks of rays first, then of single ones. What stays open is
// tried again with closer bounds, in doubles where the driver's can be trusted (doubles.h). Each
// ray is as thick as all that float32 may have made of it, see scene/ray_rounding.h: what is proved
// holds for the ray that was drawn, on any driver. A proved hit is a simple root, the ray's first,
// within an eighth of a pixel's width of the place that was found.
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
#include "gpu/target.h"
#include "render/march_plan.h"
#include "render/pass_table.h"
#include "render/proof_rays.h"

namespace isomotion::render {

// The codes of the channel proof.
enum class Proof {
    none,      // the march ended with neither a root nor a miss, or rays are beyond float32
    hit,       // proved
    miss,      // proved
    hidden,    // a root may lie before the one found, or where none was
    sign,      // F may not change its sign, or more than once, where the root was found
    budget,    // too many pieces
    unbounded, // F or its slope has no bound on some piece
};
inline constexpr std::array<std::string_view, 7> proof_names{
    "not looked at", "hit", "miss", "may be hidden", "sign undecided", "budget", "unbounded"};
using ProofCounts = std::array<std::int64_t, proof_names.size()>; // of pixels, by Proof

constexpr bool is_proved(Proof proof) { return proof == Proof::hit || proof == Proof::miss; }
double proved_part(const ProofCounts& counts); // 0 to 1
// "proved 99.3 %; not proved: 0.5 % sign undecided, 0.2 % may be hidden"
std::string summary(const ProofCounts& counts);

class Proofs {
public:
    // Pieces after which a ray's proof is given up.
    static constexpr int most_pieces = 128;
    // And those of a block, whose rays' own proofs go on.
    static constexpr int most_pieces_of_block = 24;

    // Passes and scene outlive it. `mask`: of the pixels that the picture's draw marched, or null.
    // `in_doubles`: what stays open may be tried again in doubles, if the driver's can be trusted.
    // Throws std::length_error if the formula sums too many terms for a shader.
    Proofs(const synthesis::Passes& passes, const scene::Scene& scene, const MarchPlan& plan,
           const gpu::DepthMask* mask, bool in_doubles);

    // Proves the rays of a tile whose picture is drawn, their endings among its attachments. Four
    // floats a pixel, rows from the bottom: Proof, the t down to which the ray is settled, and
    // two more. `is_masked`: the mask is as the picture's draw left it.
    void prove(PassTable& table, const ProofRays& rays, const gpu::Target& picture, bool is_masked,
               const gpu::Rectangle& tile, std::span<float> record);

private:
    enum class Start { go_on, again };
    // A pass of single rays' proofs, by what a piece of them costs.
    struct Pieces {
        synthesis::Role role;
        formula::Cost cost;
    };
    void upload(PassTable& table, const ProofRays& rays);
    // What tries again what is open; none where its sums are too long for a shader.
    const std::optional<Pieces>& closer(const PassTable& table);
    // Takes on, where the mask has a ray, what is kept, and tells `drawn_` how many there are.
    void draw_and_keep(PassTable& table, const gpu::Program& program, const gpu::Rectangle& tile);
    // Begins with blocks of rays, then with single ones, where the mask has them.
    void begin(PassTable& table, const gpu::Rectangle& tile);
    // Takes rays with nothing left to prove off the mask; so many.
    std::uint32_t take_finished_off(PassTable& table, const gpu::Rectangle& tile);
    // Draws passes until the proofs that wait for these are finished, of so many rays at most.
    void prove_rays(PassTable& table, const Pieces& by, Start start, std::uint32_t rays,
                    const gpu::Rectangle& tile);

    const synthesis::Passes& passes_;
    const scene::Scene& scene_;
    bool may_take_doubles_;
    int block_pieces_; // at most
    Pieces natural_;
    std::optional<std::optional<Pieces>> closer_; // once it was asked for
    int ending_;                                  // among the picture's attachments
    gpu::Target of_coarse_blocks_, of_blocks_, kept_, going_on_;
    std::optional<gpu::DepthMask> own_mask_;
    const gpu::DepthMask& mask_; // of the last two
    gpu::UniformBuffer frame_;
    gpu::SamplesQuery drawn_; // rays
};

} // namespace isomotion::render
