// Finds elements by cell: src/elements/element_grid.h. All sums over the array use the list of the
// cell that was entered last.

uniform IM_BUFFER_OF_UINTS cells_texture;  // as Cell
uniform IM_BUFFER_OF_UINTS listed_texture; // elements

#define GRID_LOW array_grid[0].xyz
#define GRID_CELL array_grid[1].xyz
#define GRID_ACROSS ivec3(array_grid[2].xyz)
// An element left out of a list has no smaller key, or is the least nowhere in the cell.
#define GRID_LEAST array_grid[0].w
// Length of the longest list.
#define GRID_LONGEST array_grid[1].w

int GRID_COUNT = 0, grid_first = 0;
// Cost of the loops so far: elements of all cells entered, and terms of other arrays meanwhile.
int grid_entered = 0, grid_others = 0;

// The cell that holds p, or the nearest cell if p is outside of the grid.
ivec3 cell_of(vec3 p) {
    return clamp(ivec3(floor((p - GRID_LOW) / GRID_CELL)), ivec3(0), GRID_ACROSS - 1);
}

uvec2 read_cell(ivec3 place) {
    ivec3 across = GRID_ACROSS;
    int at = (place.z * across.y + place.y) * across.x + place.x;
    return IM_BUFFER_AT(cells_texture, at).xy;
}

void enter_cell(ivec3 place) {
    uvec2 cell = read_cell(place);
    GRID_COUNT = int(cell.x & 0xfffffu);
    grid_first = int(cell.y);
    grid_entered += GRID_COUNT;
    grid_others += GRID_OTHERS;
}

int listed_element(int k) {
    return int(IM_BUFFER_AT(listed_texture, grid_first + k).x);
}

// Bounds, for proofs, of what lists leave out of F's sums.
//
// At each place, the list of its cell leaves a number out of a sum, at most the grid's bound L in
// size. In the next cell along a ray this number may differ by 2 L. Statements about F hold for all
// numbers up to 64 L. So they still hold for the right one after slopes led from a place to the
// ends of two boxes, over at most 12 cells each (cells_of_box.glsl), and aside by the ray's
// rounding.
vec2 bounds_of_rest(float bound) { return 64.0 * vec2(-bound, bound); }
