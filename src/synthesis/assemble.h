// Scene -> GLSL: the files of shaders/ that the scene calls for, and the generated field.
//
// The text depends on the formula's structure, the bounds' shape, the method, the effects named,
// the number of lights and the channels asked for. It depends on no value: a frame changes uniforms
// only.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"
#include "synthesis/channel.h"
#include "synthesis/field_text.h"
#include "synthesis/stage.h"

namespace isomotion::synthesis {

// Which of an array's elements a level of beams tells apart: those that matter in all of a beam's
// part and those in its front, or only the latter; beyond it the lists of the level before hold.
enum class BeamLists { none, whole, front };

// Finds which part of their way the rays of each block of pixels need to march.
struct BeamShader {
    int block = 0; // pixels across
    BeamLists lists = BeamLists::none;
    double front = 1;    // a part of the way
    int square_bits = 0; // of its blocks, squares of 2^bits are kept apart: march/beam_place.glsl
    std::string text{};
};

// That are made of one beam.
inline int lists_of_a_block(const BeamShader& level) {
    if (level.lists == BeamLists::none) return 0;
    return level.lists == BeamLists::whole && level.front < 1 ? 2 : 1;
}

struct Shaders : FieldStorage {
    std::string vertex;
    std::string shade_vertex;      // of shade and whole
    std::string march;             // one pass of the rays
    std::vector<BeamShader> beams; // each within the one before it
    std::string active;            // asks whether rays still march
    std::string shade;             // the picture from finished rays
    std::string whole;             // march and shade in one draw, for plain pictures; else empty
    std::string open;              // of that draw: depth lets the rays pass that have to march

    // Of scenes that call for them (see effect_text.h), else empty.
    std::string surface;        // keeps where the rays ended
    std::string shadow;         // one pass of the shadow rays
    int light_beams = 0;        // a bit for each light whose shadow rays go by beams of its own
    std::string mirror;         // one pass of the mirrored rays
    std::string mirror_surface; // keeps where those ended
    std::string motion;         // of the channel velocity: F at another time

    // Of scenes that ask for proofs (Isolation::certify), else empty.
    std::string block_proof;  // of blocks of rays
    std::string begin_proof;  // of single rays
    std::string proof;        // one pass of proofs of single rays
    std::string sharp_proof;  // one of those that take closer bounds
    std::string double_proof; // and in doubles, which takes OpenGL 4.0
    std::string to_prove;     // depth lets the rays pass that have something to prove
    std::string close_proofs; // and no longer those that are proved
    std::string keep;         // copies what is kept of proofs

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
    std::vector<std::string> files; // of shaders/, as used
};

// Texels from one of the squares of a level of beams to the next.
inline constexpr int beam_square = 64;

// Whether a scene's rays go by beams: as it says, or else with the method hermite where bounds of
// the field cost less than what they save.
bool uses_beams(const scene::Scene& scene);

// Pixels across the smallest beams.
inline constexpr int usual_beam = 8;

// `writes_buffers`: shaders may (OpenGL 4.3), which the lists of beams need. `finest_beam`: 8, or 1
// for beams of single pixels, which cost more than they save.
Shaders assemble(const scene::Scene& scene, const std::vector<Channel>& channels = {},
                 Stage stage = Stage::fragment, bool writes_buffers = true,
                 int finest_beam = usual_beam);

// Changes with the text of any shader.
std::string fingerprint(const Shaders& shaders);

} // namespace isomotion::synthesis
