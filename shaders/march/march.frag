// Adaptive marching points, Algorithm 1 of Singh & Narayanan 2010, as a state machine: every turn
// of the loop samples the field once, at one place in the text. Drivers inline the field at each
// call, so a second call would double the compile time.

uniform bool first_pass;
uniform int evaluations_per_pass;

RayState begin(Ray ray) {
    bool empty = !(ray.t_near <= ray.t_far);
    return RayState(ray.t_near, vec2(0.0), ray.t_near, empty ? PHASE_DONE : PHASE_START,
                    VERDICT_MISS, 0, 0);
}

// Goes on from `low` by the step that Eq. 2 allows there.
RayState step_on(RayState s, Ray ray) {
    if (s.low >= ray.t_far) return finish(s, VERDICT_MISS);
    s.phase = PHASE_MARCH;
    s.high = min(s.low + step_size(s.f_low), ray.t_far);
    // A step below the spacing of floats would stand still.
    return s.high > s.low ? s : finish(s, VERDICT_STEP_LIMIT);
}

RayState advance(RayState s, Ray ray, float t, vec2 f) {
    s.evaluations += 1;
    if (im_is_nan(f.x)) return finish(s, VERDICT_NAN);
    if (s.phase == PHASE_GRADIENT) return take_slope(s, f);
    // A slope that is not a number (a kink, say) counts as none: only F decides a verdict.
    if (im_is_nan(f.y)) f.y = 0.0;
    bool root = s.phase != PHASE_START && root_exists(s.low, s.f_low, t, f);
    if (s.phase == PHASE_REFINE) {
        if (root) {
            s.high = t;
        } else {
            s.low = t;
            s.f_low = f;
        }
        s.bisections += 1;
    } else if (root) {
        s.phase = PHASE_REFINE;
    } else {
        s.low = t;
        s.f_low = f;
        if (s.evaluations >= int(refinement.y)) return finish(s, VERDICT_STEP_LIMIT);
        return step_on(s, ray);
    }
    return s.bisections >= int(refinement.x) ? found(s) : s;
}

void main() {
    Ray ray = pixel_ray();
    RayState s;
    if (first_pass) {
        s = begin(ray);
    } else {
        s = load_state();
    }
    for (int k = 0; k < evaluations_per_pass; ++k) {
        if (s.phase == PHASE_DONE) break;
        float t = s.phase == PHASE_REFINE ? 0.5 * (s.low + s.high) : s.high;
        vec2 f = sample_field(ray_point(ray, t), sample_direction(s, ray));
        s = advance(s, ray, t, f);
    }
    store_state(s);
}
