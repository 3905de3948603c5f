// For F that is continuous and has a value everywhere, by its operations: see breaks.glsl.

bool may_break(Ray ray, vec2 piece) {
    return false;
}

bool has_no_value(Ray ray, vec2 piece) {
    return false;
}
