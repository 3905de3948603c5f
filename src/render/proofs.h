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
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/draw.h"
#include "gpu/gate.h"
#include "gpu/program.h"
#include "gpu/query.h"
#include "gpu/target.h"
#include "render/march_plan.h"
#include "scene/rays.h"
#include "scene/scene_at.h"
#include "synthesis/assemble.h"

namespace isomotion::render {

// The codes of the channel proof.
enum class Proof {
    none,      // the march ended with neither a root nor a miss
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
    static constexpr int units = 3;
    // Pieces after which a ray's proof is given up.
    static constexpr int most_pieces = 128;
    // And those of a block, whose rays' own proofs go on.
    static constexpr int most_pieces_of_block = 24;
    // What is tried again takes a program that is made when something first is: whether it may be
    // in doubles, and what connects it to the field's values.
    struct Again {
        bool in_doubles;
        std::function<void(const gpu::Program&)> connect;
    };
    // Shaders, scene and gate outlive it. Takes texture units from `first_unit` on. `gate`: of the
    // pixels that the picture's draw marched, or null. Throws std::length_error if the formula sums
    // too many terms for a shader.
    Proofs(const synthesis::Shaders& shaders, const scene::Scene& scene, const MarchPlan& plan,
           int first_unit, const gpu::Gate* gate, Again again);

    void for_each_program(const std::function<void(const gpu::Program&)>& visit) const;

    // For the frame that is drawn next. Afterwards the frame's own block must be bound again.
    void upload(const scene::Scene& scene, const scene::SceneAt& now, int width, int height,
                const scene::Aim& aim);

    // Proves the rays of a tile whose picture is drawn, their endings among its attachments. Four
    // floats a pixel, rows from the bottom: Proof, the t down to which the ray is settled, and
    // two more. `is_gated`: the gate is as the picture's draw left it. `binding` is that of the
    // block Frame, which is left changed.
    void prove(const gpu::Target& picture, bool is_gated, const gpu::Rectangle& tile,
               unsigned binding, std::span<float> record);

private:
    enum class Start { go_on, again };
    // How thick the rays are, and how short pieces get: uniforms of shaders/proof/.
    struct Thickness {
        glm::vec4 tube{0};
        float shortest_piece = 0;
    };
    struct Pass {
        gpu::Program program;
        formula::Cost piece;
        bool in_doubles = false;
    };
    static void set(const gpu::Program& program, const Thickness& thickness);
    void set(const Pass& pass) const;
    void bind_samplers(const gpu::Program& program) const;
    void bind_inputs(const gpu::Target& picture) const;
    // Tries again what is open; null where its sums are too long for a shader. May change which
    // textures are bound.
    const Pass* closer();
    void draw(const gpu::Program& program, int width, int height) const;
    void draw(const gpu::Program& program) const;
    // Goes on with what is kept where the gate is open, and tells `drawn_` how many do.
    void draw_and_keep(const gpu::Program& program);
    // Blocks, then single rays, where the gate is open.
    void begin();
    // Draws passes until the proofs that wait for these are finished, of so many rays at most.
    void prove_rays(const Pass& pass, Start start, std::uint32_t rays);

    int block_pieces_; // at most
    gpu::Program to_prove_, close_, keep_, blocks_, begin_;
    Pass natural_;
    std::function<std::optional<Pass>()> make_closer_; // empty once it was called
    std::optional<Pass> closer_;
    Thickness of_floats_, of_doubles_;
    int ending_; // among the picture's attachments
    gpu::Target of_blocks_, kept_, going_on_;
    std::optional<gpu::Gate> own_gate_;
    const gpu::Gate& gate_; // of the last two
    gpu::UniformBuffer frame_;
    gpu::SamplesQuery drawn_; // rays, by the last draw
    gpu::Fullscreen triangle_;
    int first_unit_;
    gpu::Rectangle tile_; // being proved
};

} // namespace isomotion::render
