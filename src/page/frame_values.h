// The values of every frame of a scene: all that a page's pictures are drawn from. Where the
// shutter opens, a frame has as many moments as samples.
#pragma once

#include <string>
#include <vector>

#include "page/value_table.h"
#include "page/web_scene.h"

namespace isomotion::page {

// Numbers that stand together in a row of a table.
struct Place {
    std::string name;
    int count = 1;
};

struct FrameValues {
    // A row for each moment of each frame:
    ValueTable view{"view"};             // doubles, as `view_places` has them
    ValueTable parameters{"parameters"}; // block Parameters, std140
    ValueTable shading{"shading"};       // block Shading, std140
    ValueTable effects{"effects"};       // floats, as `effect_places` has them
    std::vector<ValueTable> arrays;      // elements, packed as the shaders read them
    // One for each frame and moment, of the array whose elements are found by place
    // (packed_grid.h): its length in bytes as a word, the least byte first, then the grid. Empty if
    // there is none.
    std::vector<std::byte> grids;
    std::vector<Place> view_places;
    std::vector<Place> effect_places; // plain uniforms; a count of 1 to 4 is a float to a vec4

    // All of these in one order.
    std::vector<const ValueTable*> tables() const;
};

// The parts of a frame that have passed at its moments: 0 first, and alone but for motion blur.
std::vector<double> moments(const scene::Scene& scene);

// Evaluates all frames. Throws SceneError where a value leaves its range and where the values take
// more than most_value_bytes, those that stand counted once; std::length_error where more elements
// matter in one place than a shader can sum.
FrameValues frame_values(const WebScene& web);

} // namespace isomotion::page
