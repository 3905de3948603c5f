// Samples F and dF/dt.
vec2 sample_field(vec3 p, vec3 direction) {
#ifdef SIGNS_IN_FREE_CELLS
    return field_directional_or_sign(p, direction);
#else
    return field_directional(p, direction);
#endif
}
