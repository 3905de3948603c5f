// Whether a point, or a box, is inside the bounds, however rounded, and though these may be grown by
// BOUNDS_ROUNDING.
bool inside_bounds(vec3 p) {
#ifdef BOX
    vec3 inset = vec3(3.0 * BOUNDS_ROUNDING);
    return all(greaterThan(p, bounds_min.xyz + inset)) && all(lessThan(p, bounds_max.xyz - inset));
#else
    return length(p - bounds_min.xyz) < bounds_min.w - 3.0 * BOUNDS_ROUNDING;
#endif
}

bool holds_within_bounds(vec2 x, vec2 y, vec2 z) {
    bool holds = true;
    for (int k = 0; k < 8; ++k) {
        holds = holds && inside_bounds(vec3((k & 1) == 0 ? x.x : x.y, (k & 2) == 0 ? y.x : y.y,
                                            (k & 4) == 0 ? z.x : z.y));
    }
    return holds;
}
