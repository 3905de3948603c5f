vec4 field_directional_interval(vec2 x, vec2 y, vec2 z, vec2 dx, vec2 dy, vec2 dz) {
    CellRange range = cells_of_box(x, y, z);
    if (range.too_many) return vec4(all_numbers, all_numbers);
    vec4 all = vec4(no_numbers, no_numbers);
    for (ivec3 at = range.first; at.z <= range.last.z; at = next_cell(range, at)) {
        enter_cell(at);
        vec2 bx = x, by = y, bz = z;
        box_in_cell(range, at, bx, by, bz);
        all = hull_of(all, field_directional_interval_in_cell(bx, by, bz, dx, dy, dz));
    }
    return all;
}
