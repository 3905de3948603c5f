// Samples F alone, for methods that need no slope.
vec2 sample_field(vec3 p, vec3 direction) {
    return vec2(field(p), 0.0);
}
