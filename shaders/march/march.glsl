// Marches rays to their first roots, as a state machine: each turn of the loop samples the field
// once, at one place in the text. Drivers inline the field at each call, so a second call would
// double the compile time. The files before this one define the method: turn().

uniform int evaluations_per_pass;
#if defined(LISTS) || defined(GRID)
uniform float element_budget;
#endif

RayState begin(Ray ray) {
    RayState s = state_at(ray.t_near);
    bool empty = !(ray.t_near <= ray.t_far);
    if (empty) s = finish(s, VERDICT_MISS);
    return s;
}

RayState march(Ray ray, RayState s) {
    // Software renderers run a loop's body once more after a break at its top.
    int turns = s.phase == PHASE_DONE ? 0 : evaluations_per_pass;
    // Loops must end before drivers end them.
#ifdef LISTS
    turns = min(turns, max(1, int(element_budget) / max(array0_count, 1)));
#endif
#ifdef GRID
    // Some eight neighbours are in cells of their own.
    int most_elements = int(0.125 * element_budget);
#endif
    if (turns > 0) {
        do {
#ifdef SOLVES
            // Software renderers skip no branch, so they should not solve at every sample.
            do {
#ifdef PASSES_FREE
                s = pass_free(s, ray);
                if (s.phase == PHASE_DONE) break;
#endif
                s = turn(s, ray);
                turns -= 1;
#ifdef GRID
                if (grid_entered > most_elements) turns = 0;
#endif
            } while (turns > 0 && s.phase < PHASE_DONE);
            s = solve(s, ray);
#else
#ifdef PASSES_FREE
            s = pass_free(s, ray);
            if (s.phase == PHASE_DONE) break;
#endif
            s = turn(s, ray);
            turns -= 1;
#ifdef GRID
            if (grid_entered > most_elements) turns = 0;
#endif
#endif
        } while (turns > 0 && s.phase != PHASE_DONE);
    }
    return s;
}
