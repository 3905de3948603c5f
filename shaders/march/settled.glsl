// The rays of settled blocks. Needs slab.glsl and found().

// The state before any sample of a ray. A settled ray begins in the middle of the slab that holds its first
// root, and is restricted to that.
RayState begin_in_slab(inout Ray ray, RayState s) {
    ivec2 pixel = ivec2(pixel_centre), block = pixel / BLOCK;
    vec4 slab = slab_of(block, SQUARE_BITS);
    if (slab.w != 0.0) {
        float middle = middle_of_slab(slab, vec2(pixel - block * BLOCK), BLOCK);
        precise float near = (middle - slab.w) * ray.to_eye, far = (middle + slab.w) * ray.to_eye;
        precise float guess = middle * ray.to_eye;
        ray.t_near = near;
        ray.t_far = far;
        s = state_at(near);
        s.f_low.x = far;
        s.high = guess;
        s.phase = PHASE_NEWTON;
    }
    return s;
}

// Newton's steps to the root of a settled ray, from a guess in its slab [t_near, t_far], where F is monotone.
// The root stays between `low` and f_low.x. Every fourth step halves that, so that turns of the slope cost little.
// `precise` makes roots the same to the bit in one draw and in several.
RayState step_by_newton(RayState s, Ray ray, float t, vec2 f) {
    bool is_behind = (f.x < 0.0) == (f.y < 0.0);
    s.low = is_behind ? s.low : t;
    s.f_low.x = is_behind ? t : s.f_low.x;
    precise float newton = t - f.x / f.y;
    bool inside = newton >= s.low && newton <= s.f_low.x;
    bool close = inside && abs(newton - t) <= 4.0 * cubics.w || s.f_low.x - s.low <= cubics.w;
    bool steps = inside && (close || (s.evaluations & 3) != 3);
    s.high = steps ? newton : s.low + 0.5 * (s.f_low.x - s.low);
    if (close) return found(s, s.high);
    if (s.evaluations >= int(limits.y)) return finish(s, VERDICT_STEP_LIMIT);
    return s;
}

#ifdef SETTLED_RAYS
// The method of rays that are all settled.
float next_sample(RayState s) {
    return s.high;
}

RayState advance(RayState s, Ray ray, float t, vec2 f) {
    s.evaluations += 1;
    if (s.phase == PHASE_GRADIENT) return take_derivative(s, f);
    return step_by_newton(s, ray, t, f);
}
#endif
