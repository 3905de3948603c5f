// Adaptive marching points, Algorithm 1 of Singh & Narayanan 2010. root_exists() determines the
// roots that it sees, step_size() the steps.

// Takes the step from `low` that Eq. 2 allows there.
RayState step_on(RayState s, Ray ray) {
    bool left = s.low >= ray.t_far, is_last = s.evaluations >= int(limits.y);
    s.phase = PHASE_MARCH;
    s.high = min(s.low + step_size(s.f_low), ray.t_far);
    // A step below the spacing of floats would stand still.
    bool goes_on = s.high > s.low && !is_last;
    if (!goes_on) s = finish(s, left && !is_last ? VERDICT_MISS : VERDICT_STEP_LIMIT);
    return s;
}

float next_sample(RayState s) {
    return s.phase == PHASE_REFINE ? 0.5 * (s.low + s.high) : s.high;
}

// Advances a ray by its sample at t: F and dF/dt are f. There is one way out: NVIDIA's compiler makes
// a loop of a function that returns from inside. That took 5 % of short formulas' time (H100).
RayState advance(RayState s, Ray ray, float t, vec2 f) {
    s.evaluations += 1;
    if (im_is_nan(f.x)) {
        s = finish(s, VERDICT_NAN);
    } else if (s.phase == PHASE_GRADIENT) {
        s = take_derivative(s, f);
    } else {
        // A NaN slope (at a kink, say) counts as 0: only F decides a verdict.
        if (im_is_nan(f.y)) f.y = 0.0;
        bool refines = s.phase == PHASE_REFINE;
        bool root = s.phase != PHASE_START && root_exists(s.low, s.f_low, t, f);
        if (!root) {
            s.low = t;
            s.f_low = f;
        }
        if (refines && root) s.high = t;
        if (refines) s.refinements += 1;
        if (refines || root) {
            s.phase = PHASE_REFINE;
            if (s.refinements >= int(limits.x)) s = found(s, 0.5 * (s.low + s.high));
        } else {
            s = step_on(s, ray);
        }
    }
    return s;
}
