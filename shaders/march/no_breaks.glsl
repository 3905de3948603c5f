// F is continuous and has a value everywhere, as far as its operations tell: see breaks.glsl.

bool may_break(Ray ray, vec2 piece) {
    return false;
}

RayState pass_break(RayState s, Ray ray) {
    return finish(s, VERDICT_STEP_LIMIT);
}

RayState no_value(RayState s, Ray ray) {
    return finish(s, VERDICT_NAN);
}
