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
