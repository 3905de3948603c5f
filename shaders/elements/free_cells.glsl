// Cells that have no root by the bounds of the sums (src/elements/element_grid.h).

// The end of the rootless part of the ray that holds t; t itself if a root may be there.
float end_of_free(Ray ray, float t) {
    // Avoids division by 0.
    vec3 direction = mix(ray.direction, vec3(1.0e-20), lessThan(abs(ray.direction), vec3(1.0e-20)));
    // Steps past a border by less than the lists extend beyond it.
    float beyond = 3.0e-5 * min(GRID_CELL.x, min(GRID_CELL.y, GRID_CELL.z));
    for (int k = 0; k < 48 && t < ray.t_far; ++k) {
        vec3 p = ray_point(ray, t);
        ivec3 place = cell_of(p);
        uvec2 cell = read_cell(place);
        int free = int(cell.x >> 20);
        if (free == 0) break;
        float around = float(free - 1);
        vec3 low = GRID_LOW + (vec3(place) - around) * GRID_CELL;
        vec3 high = low + (2.0 * around + 1.0) * GRID_CELL;
        vec3 ends = (mix(low, high, greaterThan(direction, vec3(0.0))) - p) / direction;
        t += max(min(ends.x, min(ends.y, ends.z)), 0.0) + beyond;
    }
    return min(t, ray.t_far);
}
