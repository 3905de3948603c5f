// Whether a point is inside the bounds, a box, however rounded, and though these may be grown by BOUNDS_ROUNDING.
bool inside_bounds(vec3 p) {
    vec3 inset = vec3(3.0 * BOUNDS_ROUNDING);
    return all(greaterThan(p, bounds_min.xyz + inset)) && all(lessThan(p, bounds_max.xyz - inset));
}
