// Returns the part of a ray inside the bounds, a box; (1, 0) if it is empty.
vec2 clip_to_bounds(vec3 anchor, vec3 direction) {
    // 1/0 is infinity on some drivers and NaN on others. So a ray along a face gets a slope by
    // which it leaves the slab only far outside the picture.
    vec3 slope = vec3(abs(direction.x) < 1e-12 ? 1e-12 : direction.x,
                      abs(direction.y) < 1e-12 ? 1e-12 : direction.y,
                      abs(direction.z) < 1e-12 ? 1e-12 : direction.z);
    vec3 a = (bounds_min.xyz - anchor) / slope;
    vec3 b = (bounds_max.xyz - anchor) / slope;
    vec3 enter = min(a, b), leave = max(a, b);
    float near = max(max(enter.x, enter.y), enter.z);
    float far = min(min(leave.x, leave.y), leave.z);
    return near <= far ? vec2(near, far) : vec2(1.0, 0.0);
}
