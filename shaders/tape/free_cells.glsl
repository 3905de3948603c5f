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
