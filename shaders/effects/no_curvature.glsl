// For expressions that name no curvature.
vec2 curvatures(Hit hit) {
    return vec2(0.0);
}
