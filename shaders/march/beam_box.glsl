// Boxes and the bounds, if these are a box.

vec3 bounds_low() { return bounds_min.xyz - beam.w; }
vec3 bounds_high() { return bounds_max.xyz + beam.w; }

bool meets_bounds(vec2 x, vec2 y, vec2 z) {
    vec3 a = bounds_low(), b = bounds_high();
    return x.x <= b.x && x.y >= a.x && y.x <= b.y && y.y >= a.y && z.x <= b.z && z.y >= a.z;
}
