// Moves rays past cells where there is no root.

#ifdef GRID
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
#else
// Cells in which F keeps off 0 (src/formula/tape/tape_cells.h).

// The end of the rootless part of the ray that holds t; t itself if a root may be there.
float end_of_free(Ray ray, float t) {
    // Avoids division by 0.
    vec3 direction = mix(ray.direction, vec3(1.0e-20), lessThan(abs(ray.direction), vec3(1.0e-20)));
    vec3 finest = TAPE_SIZE / exp2(TAPE_LEVELS);
    // Steps past a border by less than a cell's tape holds around it.
    float beyond = 0.03 * min(finest.x, min(finest.y, finest.z));
    for (int k = 0; k < 48 && t < ray.t_far; ++k) {
        vec3 p = ray_point(ray, t);
        uvec2 span = tape_of_cell(TAPE_OF_RAYS, TAPE_LEVELS, 0.0625, p, p);
        if ((span.y & 0x80000000u) == 0u) break;
        float along = exp2(float((span.y >> 24) & 7u));
        vec3 side = TAPE_SIZE / along;
        vec3 low = TAPE_LOW + clamp(floor((p - TAPE_LOW) / side), 0.0, along - 1.0) * side;
        vec3 ends = (mix(low, low + side, greaterThan(direction, vec3(0.0))) - p) / direction;
        t += max(min(ends.x, min(ends.y, ends.z)), 0.0) + beyond;
    }
    return min(t, ray.t_far);
}
#endif

RayState pass_free(RayState s, Ray ray) {
    if (s.phase != PHASE_START && s.phase != PHASE_MARCH) return s;
    float t = end_of_free(ray, s.low);
    if (!(t > s.low)) return s;
    s.low = s.high = t;
    s.phase = PHASE_START;
    s.refinements = 0;
    s.other = vec3(0.0);
    s.open_end = 0.0;
    if (t >= ray.t_far) return finish(s, VERDICT_MISS);
    return s;
}
