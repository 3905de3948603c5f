// Whether a point is inside the bounds, a sphere, however rounded, and though these may be grown by BOUNDS_ROUNDING.
bool inside_bounds(vec3 p) {
    return length(p - bounds_min.xyz) < bounds_min.w - 3.0 * BOUNDS_ROUNDING;
}
