// The values of every frame of a scene: all that a page's pictures are drawn from.
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
    // A row a frame:
    ValueTable view{"view"};             // doubles, as `view_places` has them
    ValueTable parameters{"parameters"}; // block Parameters, std140
    ValueTable shading{"shading"};       // block Shading, std140
    ValueTable effects{"effects"};       // floats, as `effect_places` has them
    std::vector<ValueTable> arrays;      // elements, packed as the shaders read them
    std::vector<Place> view_places;
    std::vector<Place> effect_places; // plain uniforms; a count of 1 to 4 is a float to a vec4

    // All of these in one order.
    std::vector<const ValueTable*> tables() const;
};

// Evaluates all frames. Throws SceneError where a value leaves its range.
FrameValues frame_values(const WebScene& web);

} // namespace isomotion::page
