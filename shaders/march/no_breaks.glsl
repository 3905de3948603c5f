// F is continuous and has a value everywhere, as far as its operations tell: see breaks.glsl.

bool may_break(Ray ray, vec2 piece) {
    return false;
}

bool has_no_value(Ray ray, vec2 piece) {
    return false;
}
