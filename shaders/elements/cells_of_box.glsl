// Bounds over a box of numbers REAL: the hull of the bounds over its parts in each cell. A box has
// no bounds if it meets more than MOST_CELLS cells or takes more than MOST_ELEMENTS elements.

struct CellRange {
    ivec3 first, last;
    bool too_many;
    bool is_empty; // the first cell stands for all
};

// Whether no element matters in any of these cells, by the empty cells around the middle one.
bool are_empty(ivec3 first, ivec3 last) {
    ivec3 middle = (first + last) / 2, reach = last - middle;
    uvec2 cell = read_cell(middle);
    int around = int(min(cell.y, 4096u));
    return (cell.x & 0xfffffu) == 0u && max(reach.x, max(reach.y, reach.z)) <= around;
}

// Length of the longest list of a range's cells.
float longest_of(ivec3 first, ivec3 last) {
    ivec3 n = last - first + 1;
    uint longest = 0u;
    for (int k = 0; k < n.x * n.y * n.z; ++k) {
        ivec3 place = first + ivec3(k % n.x, k / n.x % n.y, k / (n.x * n.y));
        longest = max(longest, read_cell(place).x & 0xfffffu);
    }
    return float(longest);
}

CellRange cells_of_box(REAL2 rx, REAL2 ry, REAL2 rz) {
    vec2 x = vec2(rx), y = vec2(ry), z = vec2(rz);
    // Counts the next cell, too, if rounding may move an end of the box into it.
    vec3 slack = GRID_CELL * 6.1e-5 + 2.4e-7 * (abs(vec3(x.x, y.x, z.x)) + abs(vec3(x.y, y.y, z.y)));
    ivec3 first = cell_of(vec3(x.x, y.x, z.x) - slack), last = cell_of(vec3(x.y, y.y, z.y) + slack);
    ivec3 n = last - first + 1;
    if (are_empty(first, last)) return CellRange(first, first, false, true);
    bool bounded = all(lessThan(n, ivec3(MOST_CELLS + 1)));
    int cells = bounded ? n.x * n.y * n.z : MOST_CELLS + 1;
    if (cells > MOST_CELLS) return CellRange(first, last, true, false);
    float others = float(cells * GRID_OTHERS);
    float most = float(MOST_ELEMENTS);
    bool too_many = float(cells) * GRID_LONGEST + others > most;
    // A turn takes neighbours as long as the longest list among them. So not the sum of these cells'
    // lists counts, but the longest one for each.
    if (too_many) too_many = float(cells) * longest_of(first, last) + others > most;
    return CellRange(first, last, too_many, false);
}

// The part of a box's side in a cell and a little around it. The outermost cells extend beyond the
// grid.
REAL2 side_in_cell(REAL2 side, int k, float low, float cell, int across) {
    float slack = cell * 6.1e-5 + 2.4e-7 * float(abs(side.x) + abs(side.y));
    REAL begin = low + float(k) * cell - slack, end = low + float(k + 1) * cell + slack;
    return REAL2(k > 0 ? max(side.x, begin) : side.x, k < across - 1 ? min(side.y, end) : side.y);
}

void box_in_cell(CellRange range, ivec3 place, inout REAL2 x, inout REAL2 y, inout REAL2 z) {
    if (range.is_empty) return;
    x = side_in_cell(x, place.x, GRID_LOW.x, GRID_CELL.x, GRID_ACROSS.x);
    y = side_in_cell(y, place.y, GRID_LOW.y, GRID_CELL.y, GRID_ACROSS.y);
    z = side_in_cell(z, place.z, GRID_LOW.z, GRID_CELL.z, GRID_ACROSS.z);
}

// The next cell of a range, x first. After the last cell, z is beyond the range.
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

REAL2 hull_of(REAL2 a, REAL2 b) {
    return REAL2(min(a.x, b.x), max(a.y, b.y));
}

REAL4 hull_of(REAL4 a, REAL4 b) {
    return REAL4(hull_of(a.xy, b.xy), hull_of(a.zw, b.zw));
}

#define NO_NUMBERS REAL2(IM_LARGEST, -IM_LARGEST)
#define ALL_NUMBERS REAL2(-IM_LARGEST, IM_LARGEST)
