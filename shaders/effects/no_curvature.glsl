// For an expression that names none.
vec2 curvatures(Hit hit) {
    return vec2(0.0);
}
