// Of shadow rays: any root will do.

const int RAY_GOES_ON = 0, RAY_IS_FREE = 1, RAY_IS_HIDDEN = 2;

int any_hit(inout RayState s, Ray ray, vec2 f, float finest) {
    RayState next = advance(s, ray, s.high, f);
    if (next.phase == PHASE_REFINE) return RAY_IS_HIDDEN;
    if (next.phase == PHASE_DONE) return next.verdict == VERDICT_HIT ? RAY_IS_HIDDEN : RAY_IS_FREE;
    next.evaluations = s.evaluations;
    next.refinements = s.refinements; // of shadow rays they count the lights
    s = next;
    return RAY_GOES_ON;
}
