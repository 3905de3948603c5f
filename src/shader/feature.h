// What a pass is: the features that decide which parts of the shader files it has, and the values
// that these are compiled with. Files ask for them by the names of macros: #ifdef SECTIONS.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace isomotion::shader {

enum class Feature {
    // The pass.
    compute,        // a compute shader: otherwise a fragment shader
    rectangles,     // its vertex shader draws rectangles,
    squares,        // or squares: otherwise the whole viewport
    flat_shading,   // the vertex shader passes the shading inputs on
    workgroup_side, // pixels
    // What its rays and beams know.
    eye_rays,             // rays are those of the eye,
    mirrored_rays,        // or mirrored ones,
    path_rays,            // or those of paths through glass
    ended_rays,           // or those of the eye up to what is seen
    draws_at_once,        // march and picture are one draw
    settled_rays,         // all rays are settled
    march_takes_gradient, // the march samples the gradient at the root
    caps_by_samples,      // samples of the march tell where caps are
    bounds_pieces,        // the method bounds F over pieces of rays
    counts_rays,          // the pass counts rays,
    masks_blocks,         // or masks the blocks of beams
    three_samples,        // the state of a ray has three samples
    beams,                // rays begin and end by beams
    lists,                // elements are found by lists
    grid,                 // or by place
    copies,               // lists are copies in a texture
    branches,             // the processor skips what no ray of a group needs
    scene_steps,          // the method steps by a length of the scene,
    adaptive_steps,       // adapted to F,
    taylor_test,          // and tests by linear extensions
    samples_slope,        // the method samples dF/dt, too
    breaks,               // F may jump or lack a value
    rough,                // intervals judge where F isn't smooth
    walls,                // where F jumps is a wall
    bounded_touches,      // bounds judge where cubics take F for 0
    most_tries,           // the boxes in which they do
    solves,               // rays are solved between two samples
    settles,              // beams by models have settled blocks
    passes_free,          // rays pass cells without roots
    signs_in_free_cells,  // whose samples are a number of F's sign
    footprint,            // highlights are blurred by a pixel's footprint
    // What is seen.
    box,              // the bounds are a box: otherwise a sphere
    hits,             // there are hits, for ends of rays to become
    meets_ground,     // rays end on the ground, too
    mirrored_shadows, // there are shadow rays where mirrored rays ended,
    glass_shadows,    // and on the ground seen through glass
    environment,      // there is a map of what is around,
    sky_environment,  // which is the background, or that is
    sky_gradient,     // of two colours
    ambient,          // light from everywhere has two colours
    fog,
    transparent,    // pictures have no background
    ggx,            // the material is of facets,
    blinn_phong,    // or has a highlight on a matt surface
    lights,         // how many
    near_lights,    // some lights are at places
    shadows,        // a bit for each light that casts shadows
    light_beams,    // a bit for each light with beams of its own
    sections,       // how many
    section_balls,  // a bit for each ball
    parts,          // the most parts that they leave of a ray
    surfaces,       // how many
    surface,        // which this is, from 0 on
    ends_before,    // rays end at the surfaces before this one
    moved_ends,     // ends of rays are moved to the coordinates of this surface
    mirrors,        // a bit for each surface that mirrors the others
    follows_paths,  // light follows paths among several surfaces
    two_sides,      // a colour for the side where F < 0
    paint,          // the colour is an expression: a number's,
    color_by_place, // or three of them
    blue_yellow,    // the map of the number's colours
    curvature,      // the expression names curvatures
    contours,       // lines over the colour
    cap_color,      // caps of sections have a colour of their own
    glass,          // the surface is of glass
    mirrors_all,    // the surface mirrors the others
    ground,         // there is a plane below
    stores_paths,   // the pass stores paths,
    ended_paths,    // masks those that ended,
    begins_paths,   // finds where they begin,
    ends_at_bounds, // or ends them at bounds
    most_crossings, // of bounds by a path
    // Attachments.
    depth_location,
    normal_location,
    position_location,
    cap_location,
    surface_location,
    ending_location,
    way_location,
    // Blocks of pixels and their beams.
    beam_boxes,  // the pass is about boxes around beams
    block,       // pixels across
    square_bits, // march/beam_place.glsl
    squares_apart,
    parent_block, // of the beams that these lie in
    parent_square_bits,
    parent_settles,
    both_ends,        // 1: beams are shortened from both ends
    trimmed,          // by models, from both ends
    list_of_all,      // 1: a level of beams makes lists for the whole beam
    lists_of_a_block, // how many
    front,            // of a beam, as a part of all
    pieces,           // of a beam in which elements are bounded
    front_pieces,
    most_terms,
    left_out, // of a sum, relative to its value at roots, by lists of a level: march/beam_list.glsl
    texels,   // of an element
    // Copies of elements: march/copies.glsl.
    level,
    slots,
    first_slots,
    first_block,
    middle_slots,
    middle_block,
    last_slots,
    last_level,
    larger_block,
    mask_texels,
    texels_of_none,
    // Elements by place, and tapes.
    most_cells,
    most_elements,
    grid_others,
    tape_of_rays,
    tape_inputs,
    run_tape_of_rays,
    calls, // the tape is one of groups, which it calls
    // Proofs.
    hessian,           // there are second derivatives
    value_by_model,    // F at a point is bounded by a model,
    value_by_gradient, // or by its gradient
    doubles,           // the proof is in doubles
    rays,              // of a block
    coarse,            // the block is a coarse one
    coarse_block,      // pixels across those
    proved_block,      // pixels across blocks
    whole_blocks,      // rays are drawn by blocks
    list_across,       // texels in a row of the list of open rays
    bounds_rounding,   // by which the bounds may be off
    // Probes of a driver.
    literals,
    chains,
    unrolled,
    fused, // 1: multiply-adds are
};

// A flag is not in the text, which has only the parts that ask for it; a value is.
enum class FeatureKind { flag, value };
struct FeatureTraits {
    Feature feature;
    std::string_view macro;
    FeatureKind kind = FeatureKind::value;
};
const FeatureTraits& traits(Feature feature);
std::optional<Feature> feature_of(std::string_view macro);
// The macro that is spelled most like a name, or empty.
std::string nearest_feature(std::string_view name);

// The features of one text and their values.
class Features {
public:
    // False if the text has it already. Throws std::logic_error if it has another value, or if a
    // file that asked before was told that the text lacks it.
    bool add(Feature feature, std::string value = "1");
    // These answer files, and remember what they answered.
    bool has(Feature feature);
    int value(Feature feature); // 0 if the text lacks it, as in C

private:
    std::map<Feature, std::string> values_;
    std::set<Feature> denied_;
};

} // namespace isomotion::shader
