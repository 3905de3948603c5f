// Samples F and dF/dt.
vec2 sample_field(vec3 p, vec3 direction) {
    return field_directional(p, direction);
}
