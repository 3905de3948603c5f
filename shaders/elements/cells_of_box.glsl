// Bounds over a box: the hull of those over its parts in each cell. A box in more cells than most
// has none.
const int most_cells_of_box = 12;

struct CellRange {
    ivec3 first, last;
    bool too_many;
    bool is_empty; // the first cell stands for all
};

// Whether no element matters in any of the cells, as the one in their middle tells.
bool are_empty(ivec3 first, ivec3 last) {
    ivec3 middle = (first + last) / 2, reach = last - middle;
    uvec2 cell = read_cell(middle);
    int around = int(min(cell.y, 4096u));
    return (cell.x & 0xfffffu) == 0u && max(reach.x, max(reach.y, reach.z)) <= around;
}

CellRange cells_of_box(vec2 x, vec2 y, vec2 z) {
    // Where rounding may take an end for one of the next cell's, that cell counts.
    vec3 slack = GRID_CELL * 6.1e-5 + 2.4e-7 * (abs(vec3(x.x, y.x, z.x)) + abs(vec3(x.y, y.y, z.y)));
    ivec3 first = cell_of(vec3(x.x, y.x, z.x) - slack), last = cell_of(vec3(x.y, y.y, z.y) + slack);
    ivec3 n = last - first + 1;
    if (are_empty(first, last)) return CellRange(first, first, false, true);
    bool bounded = all(lessThan(n, ivec3(most_cells_of_box + 1)));
    return CellRange(first, last, !bounded || n.x * n.y * n.z > most_cells_of_box, false);
}

// The part of a box's side in a cell and a little around it; what lies outside of the grid belongs
// to its outermost cells.
vec2 side_in_cell(vec2 side, int k, float low, float cell, int across) {
    float slack = cell * 6.1e-5 + 2.4e-7 * (abs(side.x) + abs(side.y));
    float begin = low + float(k) * cell - slack, end = low + float(k + 1) * cell + slack;
    return vec2(k > 0 ? max(side.x, begin) : side.x, k < across - 1 ? min(side.y, end) : side.y);
}

void box_in_cell(CellRange range, ivec3 place, inout vec2 x, inout vec2 y, inout vec2 z) {
    if (range.is_empty) return;
    x = side_in_cell(x, place.x, GRID_LOW.x, GRID_CELL.x, GRID_ACROSS.x);
    y = side_in_cell(y, place.y, GRID_LOW.y, GRID_CELL.y, GRID_ACROSS.y);
    z = side_in_cell(z, place.z, GRID_LOW.z, GRID_CELL.z, GRID_ACROSS.z);
}

// The next cell of a range, x first; past the last one z is beyond it.
ivec3 next_cell(CellRange range, ivec3 place) {
    place.x += 1;
    if (place.x > range.last.x) {
        place.x = range.first.x;
        place.y += 1;
    }
    if (place.y > range.last.y) {
        place.y = range.first.y;
        place.z += 1;
    }
    return place;
}

vec2 hull_of(vec2 a, vec2 b) {
    return vec2(min(a.x, b.x), max(a.y, b.y));
}

vec4 hull_of(vec4 a, vec4 b) {
    return vec4(hull_of(a.xy, b.xy), hull_of(a.zw, b.zw));
}

const vec2 no_numbers = vec2(IM_LARGEST, -IM_LARGEST);
const vec2 all_numbers = vec2(-IM_LARGEST, IM_LARGEST);
