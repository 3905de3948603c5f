// Samples F, and dF/dt where the method needs a slope.
#ifdef SIGNS_IN_FREE_CELLS
// Samples of F and dF/dt that run no tape in cells without roots. There they are a number of F's
// sign, which is enough where bounds judge.

bool tape_is_free = false; // whether the last sample was one

vec2 field_directional_or_sign(vec3 p, vec3 d) {
    uvec2 span = tape_of_cell(TAPE_OF_RAYS, TAPE_LEVELS, 0.0625, p, p);
    tape_is_free = (span.y & 0x80000000u) != 0u;
    vec2 f = vec2((span.y & 0x40000000u) != 0u ? -1.0e-30 : 1.0e-30, 0.0);
    if (!tape_is_free) {
        vec3 at[2] = vec3[2](p, d);
        for (int k = 0; k < TAPE_INPUTS; ++k) tape_numbers[k] = at[k / 3][k % 3];
        RUN_TAPE_OF_RAYS(without_notes(span));
        f = vec2(tape_numbers[TAPE_INPUTS], tape_numbers[TAPE_INPUTS + 1]);
    }
    return f;
}
#endif

vec2 sample_field(vec3 p, vec3 direction) {
#if defined(SIGNS_IN_FREE_CELLS)
    return field_directional_or_sign(p, direction);
#elif defined(SAMPLES_SLOPE)
    return field_directional(p, direction);
#else
    return vec2(field(p), 0.0);
#endif
}
