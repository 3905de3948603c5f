// Shadow rays. Any root will do, so a ray that begins to refine a root is hidden.

const int RAY_GOES_ON = 0, RAY_IS_FREE = 1, RAY_IS_HIDDEN = 2, RAY_IS_SOLVED = 3;

int any_hit(inout RayState s, Ray ray, float finest) {
    RayState next = turn(s, ray);
    if (next.phase == PHASE_REFINE) return RAY_IS_HIDDEN;
    if (next.phase == PHASE_DONE) return next.verdict == VERDICT_HIT ? RAY_IS_HIDDEN : RAY_IS_FREE;
    // These two count samples and lights here.
    next.evaluations = s.evaluations;
    next.refinements = s.refinements;
    s = next;
    return s.phase == PHASE_SOLVE ? RAY_IS_SOLVED : RAY_GOES_ON;
}

#ifdef BOUNDED_TOUCHES
// Continues a ray whose turn left it to solve().
int any_hit_solved(inout RayState s, Ray ray) {
    RayState next = solve(s, ray);
    if (next.phase == PHASE_DONE) return next.verdict == VERDICT_HIT ? RAY_IS_HIDDEN : RAY_IS_FREE;
    s.phase = next.phase;
    return RAY_GOES_ON;
}
#endif
