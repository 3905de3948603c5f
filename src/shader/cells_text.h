// Functions of a field whose elements are found by place. At a point they sum over the elements of
// its cell; over a box they are the hull over the cells that it meets.
#pragma once

#include <string>
#include <vector>

#include "shader/field_text.h"

namespace isomotion::shader {

class ShaderText;

// Adds cells and lists of the array with a grid, after the declarations of the field's storage.
void add_cells(ShaderText& text, const FieldStorage& storage, int array);

// A generated function that first looks up the cell of its place, "vec3 p".
std::string entering_cells(std::string glsl);
// A generated function that loops over all elements, whatever the current cell.
std::string over_all_elements(const FieldStorage& storage, int array, const std::string& glsl);
// A field's function: for a place as above; for a box under another name, for one cell.
std::string in_cells(FieldFunction function, const std::string& glsl);
// Adds the functions that combine the box's parts in all cells.
void add_hulls_over_cells(ShaderText& text, const std::vector<FieldFunction>& functions);

} // namespace isomotion::shader
