// The programs that draw a scene's frames, as data: what each is for, when it runs, its text, and
// what that declares.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/method.h"
#include "synthesis/channel.h"
#include "synthesis/field_text.h"
#include "synthesis/stage.h"

namespace isomotion::synthesis {

// What a pass does, in the order in which a tile is drawn.
enum class Role {
    beams,          // finds what part of their way blocks of rays need to march; one pass a level
    beam_copies,    // copies the elements that matter in those, where shaders can write no lists
    mask,           // depth lets the fused pass run where rays have a way to march
    fused,          // march and picture in one draw, of plain scenes
    march,          // takes rays some turns on
    active,         // counts the rays that still march
    surface,        // keeps where rays ended, for the passes that begin there
    mirror,         // marches the mirrored rays
    mirror_surface, // keeps where those ended
    glass_first,    // where the eye's rays met glass, begins the rays that go through it
    glass,          // marches those
    glass_next,     // goes on from where they ended: what they bring, and the next ray
    glass_copy,     // copies those that went on to where all are kept
    glass_mask,     // depth lets the next passes run where paths go on
    glass_active,   // counts those
    glass_ground,   // what they met of the ground, for shadow rays
    seen,           // colours what the mirrored rays see of one surface among several
    shadow,         // marches the shadow rays
    occlusion,      // what one surface among several leaves of the light from everywhere
    shade,          // makes the picture from finished rays
    motion,         // F and its gradient at another time, where rays ended
    // Proofs, of scenes that ask for them: see render/proofs.h.
    proof_mask,         // depth lets proofs run where rays have something to prove
    coarse_block_proof, // proves what is before all roots of larger blocks of rays
    block_proof,        // proves blocks of rays together
    first_proof,        // begins the proofs of single rays
    proof,              // takes them some pieces on
    proof_copy,         // copies those that went on to where all are kept
    proof_unmask,       // depth keeps finished ones from running
    sharp_proof,        // tries again what is open, by bounds through the gradient
    double_proof,       // the same in doubles
};

enum class When {
    once_a_tile,
    until_rays_end,      // again and again
    where_fused_ends,    // the same, once a tile's rays did not all end in the fused pass
    until_proved,        // again and again
    where_proof_is_open, // the same, for rays that the first proofs leave open
    at_two_times,        // about the frame's
};

constexpr bool is_proof(Role role) { return role >= Role::proof_mask; }
// Whether most frames do without: such a pass is compiled when it is first needed.
constexpr bool is_exceptional(When when) {
    return when == When::where_fused_ends || when == When::where_proof_is_open;
}
std::string_view words(When when); // "once a tile"

struct Pass {
    Role role{};
    std::string name; // its own: "march", "beams of 16 pixels"
    When when = When::once_a_tile;
    int level = 0; // of beams, from the coarsest
    Stage stage = Stage::fragment;
    std::string vertex;             // empty in the compute stage
    std::string text;               // the fragment or compute shader
    std::vector<std::string> files; // of shaders/, as used

    // The names that its text declares, in order.
    std::vector<std::string> blocks;   // of uniforms
    std::vector<std::string> samplers; // textures that it reads
    std::vector<std::string> outputs;  // attachments that it writes
};

// Finds the declarations in the texts and notes them in the pass.
void note_declarations(Pass& pass);

// Which of an array's elements a level of beams tells apart: those that matter in all of a beam's
// part and those in its front, or only the latter; beyond it the lists of the level before hold.
enum class BeamLists { none, whole, front };

// A level of beams, whose pass finds which part of their way the rays of each block need to march.
struct BeamLevel {
    int block = 0; // pixels across
    BeamLists lists = BeamLists::none;
    double front = 1;    // a part of the way
    int square_bits = 0; // of its blocks, squares of 2^bits are kept apart: march/beam_place.glsl
};

// How many lists a block of the level has.
inline int lists_of_a_block(const BeamLevel& level) {
    if (level.lists == BeamLists::none) return 0;
    return level.lists == BeamLists::whole && level.front < 1 ? 2 : 1;
}

struct Passes;
// The same where one draw is never enough: without the fused pass and its mask.
Passes without_fused_pass(Passes passes);

// What draws a scene: the passes in the order of a frame, and how values are laid out for them.
struct Passes : FieldStorage {
    std::vector<Pass> list;
    std::vector<BeamLevel> beams;  // each within the one before it
    int light_beams = 0;           // a bit for each light whose shadow rays go by beams of its own
    Stage stage = Stage::fragment; // of march, shadow and mirror; the others are of fragments
    int state_textures = 2;        // that a ray's state takes between passes
    // Of the polynomial in t that the method chebyshev solves, else 0. A pass must hold its
    // degree + 1 samples.
    int degree = 0;
    // What a turn of a march asks of the field; and whether, the formula being long, the march also
    // samples the gradient at the root, which else the shade pass does.
    std::vector<FieldFunction> samples;
    bool march_takes_gradient = false;
    // Attachments of the shade pass: 0 colour, 1 what is counted (render/record.h), then these.
    std::vector<Channel> attachments;

    // The pass of that role, or null.
    const Pass* find(Role role, int level = 0) const;
    bool has(Role role) const { return find(role) != nullptr; }
    // Asserts that it is there.
    const Pass& at(Role role, int level = 0) const;

    std::vector<std::string> files() const; // of shaders/, each once, as first used
    // Changes with every shader's text.
    std::string fingerprint() const;
};

} // namespace isomotion::synthesis
