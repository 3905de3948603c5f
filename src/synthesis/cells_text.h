// Functions of a field whose elements are found by place: at a point they take the elements of its
// cell, over a box they are the hull over the cells that it meets.
#pragma once

#include <string>
#include <vector>

#include "synthesis/field_text.h"

namespace isomotion::synthesis {

class ShaderText;

// Cells and their lists, behind the declarations of the field's storage.
void add_cells(ShaderText& text, const FieldStorage& storage);

// A generated function that begins by entering the cell of its place, "vec3 p".
std::string entering_cells(std::string glsl);
// A generated function whose loops go over all elements, whatever cell was entered.
std::string over_all_elements(const FieldStorage& storage, const std::string& glsl);
// A field's function: of a place as above; of a box by another name, for one cell.
std::string in_cells(FieldFunction function, const std::string& glsl);
// And the functions that take the box's parts in all cells.
void add_hulls_over_cells(ShaderText& text, const std::vector<FieldFunction>& functions);

// Rays pass cells without roots.
void add_way_past_free_cells(ShaderText& text);

} // namespace isomotion::synthesis
