// Marches rays to their first roots, as a state machine: every turn of the loop samples the field
// once, at one place in the text. Drivers inline the field at each call, so a second call would
// double the compile time. The method is in the files before this one: turn().

uniform int evaluations_per_pass;
#ifdef LISTS
uniform float element_budget;
#endif

RayState begin(Ray ray) {
    RayState s = state_at(ray.t_near);
    bool empty = !(ray.t_near <= ray.t_far);
    return empty ? finish(s, VERDICT_MISS) : s;
}

RayState march(Ray ray, RayState s) {
    // Software renderers go through a loop's body once more after a break at its top.
    int turns = s.phase == PHASE_DONE ? 0 : evaluations_per_pass;
#ifdef LISTS
    // Loops must end before drivers end them.
    turns = min(turns, max(1, int(element_budget) / max(array0_count, 1)));
#endif
    if (turns > 0) {
        do {
#ifdef SOLVES
            // Software renderers, which skip no branch, should not solve at every sample.
            do {
                s = turn(s, ray);
                turns -= 1;
            } while (turns > 0 && s.phase < PHASE_DONE);
            s = solve(s, ray);
#else
            s = turn(s, ray);
            turns -= 1;
#endif
        } while (turns > 0 && s.phase != PHASE_DONE);
    }
    return s;
}
