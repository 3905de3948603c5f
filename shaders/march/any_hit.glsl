#ifdef SCENE_STEPS
// Shadow rays for the paper's methods. Any root will do, so there is no refinement (Singh &
// Narayanan 2010, IV-B). But where a test suspects a root although the signs at both ends agree, it
// must still do so in half the step, down to `finest`.

int most_of_a_shadow_ray() {
    return int(limits.y);
}

const int RAY_GOES_ON = 0, RAY_IS_FREE = 1, RAY_IS_HIDDEN = 2, RAY_IS_UNDECIDED = 4;

int any_hit(inout RayState s, Ray ray, float finest) {
    vec2 f = sample_field(ray_point(ray, s.high), ray.direction);
    if (im_is_nan(f.y)) f.y = 0.0;
    bool hidden = s.phase == PHASE_MARCH && root_exists(s.low, s.f_low, s.high, f);
    bool suspected = hidden && (f.x < 0.0) == (s.f_low.x < 0.0);
    if (suspected && s.high - s.low > finest) {
        s.high = 0.5 * (s.low + s.high);
        return RAY_GOES_ON;
    }
    if (hidden) return RAY_IS_HIDDEN;
    if (im_is_nan(f.x) || s.high >= ray.t_far) return RAY_IS_FREE;
    s.low = s.high;
    s.f_low = f;
    s.phase = PHASE_MARCH;
    s.high = min(s.low + step_size(f), ray.t_far);
    return s.high > s.low ? RAY_GOES_ON : RAY_IS_UNDECIDED;
}
#else
// Shadow rays. Any root will do, so a ray that begins to refine a root is hidden.

const int RAY_GOES_ON = 0, RAY_IS_FREE = 1, RAY_IS_HIDDEN = 2, RAY_IS_SOLVED = 3;
const int RAY_IS_UNDECIDED = 4;

// Steps follow F, so hundreds of them are many. Along a crease pieces of rays may stay open down to
// the finest.
int most_of_a_shadow_ray() {
    return min(int(limits.y), 2000);
}

int outcome_of_end(int verdict) {
    if (verdict == VERDICT_HIT) return RAY_IS_HIDDEN;
    return verdict == VERDICT_STEP_LIMIT ? RAY_IS_UNDECIDED : RAY_IS_FREE;
}

int any_hit(inout RayState s, Ray ray, float finest) {
    RayState own = s;
    own.evaluations = 0; // counted for all lights and every method in one place
    RayState next = turn(own, ray);
    if (next.phase == PHASE_REFINE) return RAY_IS_HIDDEN;
    if (next.phase == PHASE_DONE) return outcome_of_end(next.verdict);
    next.evaluations = s.evaluations;
    s = next;
    return s.phase == PHASE_SOLVE ? RAY_IS_SOLVED : RAY_GOES_ON;
}

#ifdef BOUNDED_TOUCHES
// Continues a ray whose turn left it to solve().
int any_hit_solved(inout RayState s, Ray ray) {
    RayState next = solve(s, ray);
    if (next.phase == PHASE_DONE) return outcome_of_end(next.verdict);
    s.phase = next.phase;
    return RAY_GOES_ON;
}
#endif
#endif
