// Shadow rays of `chebyshev` look for the first root, since the sample at the root must agree.

const int RAY_GOES_ON = 0, RAY_IS_FREE = 1, RAY_IS_HIDDEN = 2;

int any_hit(inout RayState s, Ray ray, float finest) {
    RayState next = s;
    if (s.phase == PHASE_START && s.high == s.low) next.taken = 0; // of another light's ray
    next = solve(turn(next, ray), ray);
    if (next.phase == PHASE_DONE) return next.verdict == VERDICT_HIT ? RAY_IS_HIDDEN : RAY_IS_FREE;
    next.evaluations = s.evaluations;
    s = next;
    return RAY_GOES_ON;
}
