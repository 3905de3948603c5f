// Rays go past cells where no element matters, if F has no root there.

// Where the empty part of the ray that t is in ends; t where an element matters.
float past_empty(Ray ray, float t) {
    if (!GRID_IS_FREE) return t;
    vec3 direction = mix(ray.direction, vec3(1.0e-20), lessThan(abs(ray.direction), vec3(1.0e-20)));
    // Borders are passed by less than lists reach over them.
    float beyond = 3.0e-5 * min(GRID_CELL.x, min(GRID_CELL.y, GRID_CELL.z));
    for (int k = 0; k < 48 && t < ray.t_far; ++k) {
        vec3 p = ray_point(ray, t);
        ivec3 place = cell_of(p);
        uvec2 cell = read_cell(place);
        if (cell.x > 0u) break;
        float around = float(cell.y);
        vec3 low = GRID_LOW + (vec3(place) - around) * GRID_CELL;
        vec3 high = low + (2.0 * around + 1.0) * GRID_CELL;
        vec3 ends = (mix(low, high, greaterThan(direction, vec3(0.0))) - p) / direction;
        t += max(min(ends.x, min(ends.y, ends.z)), 0.0) + beyond;
    }
    return min(t, ray.t_far);
}

// A ray that stands where no element matters begins anew where one does.
RayState pass_empty(RayState s, Ray ray) {
    if (s.phase != PHASE_START && s.phase != PHASE_MARCH) return s;
    float t = past_empty(ray, s.low);
    if (!(t > s.low)) return s;
    s.low = s.high = t;
    s.phase = PHASE_START;
    s.refinements = 0;
    s.other = vec3(0.0);
    s.open_end = 0.0;
    return t >= ray.t_far ? finish(s, VERDICT_MISS) : s;
}
