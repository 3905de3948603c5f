// The programs that draw a scene's frames, as data: the purpose of each, when it runs, its text,
// and the names that the text declares.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/method.h"
#include "shader/channel.h"
#include "shader/field_text.h"
#include "shader/stage.h"

namespace isomotion::shader {

// The purpose of a pass, in the order in which a tile is drawn.
enum class Role {
    beams,          // finds what part of their way blocks of rays need to march; one pass a level
    beam_copies,    // copies the elements that matter in those, where shaders can write no lists
    mask,           // depth lets the fused pass run where rays have a way to march
    fused,          // march and picture in one draw, of plain scenes
    settled,        // the same of blocks whose beam tells where their rays' first roots are
    march,          // takes rays some turns on
    active,         // counts the rays that still march
    surface,        // keeps the ends of rays, for the passes that begin there
    mirror_mask,    // sets depth so that these run only where a mirror is seen, of several surfaces
    mirror,         // marches the mirrored rays
    mirror_surface, // keeps the ends of those
    glass_begins,   // sets depth so that the next one runs only where paths begin
    glass_first,    // begins rays through glass where the eye's rays met it
    glass,          // marches those
    glass_end,      // keeps their ends, of one surface among several
    glass_beyond,   // tells whether the matter of one among several is behind those
    glass_next,     // continues at their ends: collects their light and sets the next ray
    glass_copy,     // copies the continued paths to the target that holds all
    glass_mask,     // sets depth so that the next passes run only where paths continue
    glass_active,   // counts those
    glass_ended,    // sets depth where paths ended on the ground or on other surfaces
    glass_ground,   // the points where they met the ground, or other surfaces, for shadow rays
    seen,           // shades what further rays see of one surface among several
    shadow,         // marches the shadow rays
    occlusion,      // the part of ambient light that one surface among several lets through
    shade,          // makes the picture from finished rays
    motion,         // F and its gradient at another time, at the ends of rays
    ending,         // where rays ended, for the proofs of one surface among several
    // Proofs, for scenes that ask for them: see render/proofs.h.
    coarse_block_proof, // proves, for larger blocks of rays, the part before all roots
    block_mask,   // sets depth so that the next pass runs only where beams left a part to march
    block_proof,  // proves blocks of rays together
    first_proof,  // begins those of rays, and ends them where only the root's place was open
    proof,        // continues them by some pieces
    sharp_proof,  // tries undecided rays again, with bounds by the gradient
    double_proof, // the same in doubles
};

enum class When {
    once_a_tile,
    until_rays_end,      // repeatedly
    where_fused_ends,    // the same, if a tile's rays did not all end in the fused pass
    where_proof_is_open, // repeatedly, for rays that the first proofs leave undecided
    at_two_times,        // around the frame's time
};

constexpr bool is_proof(Role role) { return role >= Role::coarse_block_proof; }
// Whether most frames don't need it: such a pass is compiled when it is first needed.
constexpr bool is_exceptional(When when) {
    return when == When::where_fused_ends || when == When::where_proof_is_open;
}
std::string_view words(When when); // "once a tile"

struct Pass {
    Role role{};
    std::string name; // unique: "march", "beams of 16 pixels"
    When when = When::once_a_tile;
    int level = 0; // of beams, from the coarsest
    Stage stage = Stage::fragment;
    std::string vertex;             // empty in the compute stage
    std::string text;               // the fragment or compute shader
    std::vector<std::string> files; // of shaders/, as used

    // The names that its text declares, in order.
    std::vector<std::string> blocks;   // uniform blocks
    std::vector<std::string> samplers; // textures that it reads
    std::vector<std::string> outputs;  // attachments that it writes
};

// Finds the declarations in the texts and records them in the pass.
void note_declarations(Pass& pass);

// The lists of an array's elements that a level of beams makes: of those that matter anywhere in a
// beam's part and of those in its front, or only the latter. Elsewhere the lists of the level
// before apply.
enum class BeamLists { none, whole, front };

// A level of beams. Its pass finds the part of each block's rays that needs marching.
struct BeamLevel {
    int block = 0; // pixels across
    BeamLists lists = BeamLists::none;
    double front = 1;    // fraction of the part to be marched
    int square_bits = 0; // squares of 2^bits of its blocks are kept apart: march/beam_place.glsl
    // By models of F, which also settle blocks: march/beam_by_models.glsl. Otherwise by intervals.
    bool by_models = false;
};

// The number of lists per block of the level.
inline int lists_of_a_block(const BeamLevel& level) {
    if (level.lists == BeamLists::none) return 0;
    return level.lists == BeamLists::whole && level.front < 1 ? 2 : 1;
}

// What is decided of a scene's passes before any of them has its text.
struct PassPlan : FieldStorage {
    std::vector<BeamLevel> beams; // each within the one before it
    // The fused pass, if there is one; drawn over squares of blocks (render/block_squares.h), or
    // over a mask.
    bool fuses = false, draws_squares = false;
    int light_beams = 0;           // a bit for each light whose shadow rays use its own beams
    Stage stage = Stage::fragment; // of rays and beams; other passes are fragment shaders
    bool branches = false;         // steps of rays may, since the processor skips what none takes
    int state_textures = 2;        // for a ray's state between passes
    // The functions of the field that a step of the march evaluates. For long formulas the march
    // also samples the gradient at the root, which otherwise the shade pass does.
    std::vector<FieldFunction> samples;
    bool march_takes_gradient = false;
    // Attachments of the shade pass: 0 colour, 1 the counts (render/record.h), then these.
    std::vector<Channel> attachments;

    // The attachment that a channel is written to, if one is.
    std::optional<int> attachment(Channel channel) const;
};

// The programs that draw a scene, in the order of a frame, and the plan that they follow.
struct Passes : PassPlan {
    std::vector<Pass> list;
    double size_compiled = 0; // of the passes that tapes take the place of (inlined_size.h)

    // The pass with that role, or null.
    const Pass* find(Role role, int level = 0) const;
    bool has(Role role) const { return find(role) != nullptr; }
    // The same; throws std::logic_error if there is none.
    const Pass& at(Role role, int level = 0) const;

    std::vector<std::string> files() const; // of shaders/, each once, in order of first use
    // Changes with every shader's code, and not with its comments.
    std::string fingerprint() const;
};

// The same for scenes where one draw is never enough: without the fused pass and its mask.
Passes without_fused_pass(Passes passes);

} // namespace isomotion::shader
