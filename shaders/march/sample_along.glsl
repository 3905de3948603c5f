// F and dF/dt. A slope that is not a number (a kink, say) counts as none: only F decides a verdict.
vec2 sample_field(vec3 p, vec3 direction) {
    vec2 f = field_along(p, direction);
    return vec2(f.x, im_is_nan(f.y) ? 0.0 : f.y);
}
