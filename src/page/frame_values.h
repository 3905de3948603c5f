// The values of every frame of a scene, from which a page draws its pictures. With an open shutter
// a frame has as many moments as samples.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "page/computed_elements.h"
#include "page/value_table.h"
#include "page/web_scene.h"

namespace isomotion::page {

// Adjacent numbers in a row of a table.
struct Place {
    std::string name;
    int count = 1;
};

// The tables of one surface.
struct SurfaceValues {
    // One row for each moment of each frame:
    // Doubles, in the order of `view_places`: the camera is in the first surface's alone.
    ValueTable view{"view"};
    ValueTable parameters{"parameters"}; // block Parameters, std140
    ValueTable shading{"shading"};       // block Shading, std140
    ValueTable effects{"effects"};       // floats, in the order of `effect_places`
    std::vector<ValueTable> arrays;      // elements, packed as the shaders read them
    // For each array, what is left out of its table; none if it has all.
    std::vector<std::optional<ComputedElements>> computed;
    // For each frame and moment, the grid of the array whose elements are found by place
    // (packed_grid.h): its length in bytes as a little-endian word, then the grid. Empty if there
    // is none.
    std::vector<std::byte> grids;
    std::vector<Place> view_places;
    std::vector<Place> effect_places; // plain uniforms; counts of 1 to 4 are float to vec4

    // All tables in a fixed order.
    std::vector<const ValueTable*> tables() const;
};

using FrameValues = std::vector<SurfaceValues>; // of the surfaces in the file's order

// The fractions of a frame's duration at its moments: 0 first, and only 0 without motion blur.
std::vector<double> moments(const scene::Scene& scene);

// Evaluates all frames. Throws SceneError if a value leaves its range, and if the values take more
// than most_value_bytes, with constant ones counted once. Throws std::length_error if more elements
// matter in one place than a shader can sum.
FrameValues frame_values(const WebScene& web);

} // namespace isomotion::page
