// Boxes and the bounds, if these are a sphere.
vec3 bounds_low() { return bounds_min.xyz - (bounds_min.w + beam.w); }
vec3 bounds_high() { return bounds_min.xyz + (bounds_min.w + beam.w); }

bool meets_bounds(vec2 x, vec2 y, vec2 z) {
    vec3 c = bounds_min.xyz;
    vec3 off = max(max(vec3(x.x, y.x, z.x) - c, c - vec3(x.y, y.y, z.y)), 0.0);
    float reach = (bounds_min.w + beam.w) * (1.0 + 1.0e-6);
    return dot(off, off) <= reach * reach;
}
