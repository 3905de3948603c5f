// Adaptive marching points, Algorithm 1 of Singh & Narayanan 2010. root_exists() determines the
// roots that it sees, step_size() the steps.

// Takes the step from `low` that Eq. 2 allows there.
RayState step_on(RayState s, Ray ray) {
    if (s.low >= ray.t_far) return finish(s, VERDICT_MISS);
    s.phase = PHASE_MARCH;
    s.high = min(s.low + step_size(s.f_low), ray.t_far);
    // A step below the spacing of floats would stand still.
    if (s.high > s.low) return s;
    return finish(s, VERDICT_STEP_LIMIT);
}

float next_sample(RayState s) {
    return s.phase == PHASE_REFINE ? 0.5 * (s.low + s.high) : s.high;
}

// Advances a ray by its sample at t: F and dF/dt are f.
RayState advance(RayState s, Ray ray, float t, vec2 f) {
    s.evaluations += 1;
    if (im_is_nan(f.x)) return finish(s, VERDICT_NAN);
    if (s.phase == PHASE_GRADIENT) return take_derivative(s, f);
    // A NaN slope (at a kink, say) counts as 0: only F decides a verdict.
    if (im_is_nan(f.y)) f.y = 0.0;
    bool root = s.phase != PHASE_START && root_exists(s.low, s.f_low, t, f);
    if (s.phase == PHASE_REFINE) {
        if (root) {
            s.high = t;
        } else {
            s.low = t;
            s.f_low = f;
        }
        s.refinements += 1;
    } else if (root) {
        s.phase = PHASE_REFINE;
    } else {
        s.low = t;
        s.f_low = f;
        if (s.evaluations >= int(limits.y)) return finish(s, VERDICT_STEP_LIMIT);
        return step_on(s, ray);
    }
    if (s.refinements >= int(limits.x)) return found(s, 0.5 * (s.low + s.high));
    return s;
}
