// Marches rays to their first roots, as a state machine: each turn of the loop samples the field
// once, at one place in the text. Drivers inline the field at each call, so a second call would
// double the compile time. The files before this one define the method: turn(). A ray is one part, unless
// sections leave several of it: section/march.glsl.

uniform int evaluations_per_pass;
#if defined(LISTS) || defined(GRID)
uniform float element_budget;
#endif

#ifdef CAPS_BY_SAMPLES
// Decides by the first sample of a part whether it begins with a cap. section/march.glsl sets where a
// part begins.
int cut_ahead = -1;   // the section on which it begins, or -1
float cut_at = 0.0;

RayState turn_in_part(RayState s, Ray ray) {
    RayState next = turn(s, ray);
    bool begins = cut_ahead >= 0 && s.phase == PHASE_START && s.low == cut_at;
    bool is_known = next.phase == PHASE_MARCH || next.phase == PHASE_DONE && next.verdict == VERDICT_MISS;
    if (begins && is_known && next.f_low.x < 0.0) return end_on_cap(next, cut_at, cut_ahead);
    return next;
}
#else
RayState turn_in_part(RayState s, Ray ray) {
    return turn(s, ray);
}
#endif

RayState begin_part(Ray ray) {
    RayState s = state_at(ray.t_near);
    bool empty = !(ray.t_near <= ray.t_far);
    if (empty) s = finish(s, VERDICT_MISS);
    return s;
}

RayState march_part(Ray ray, RayState s) {
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
                s = turn_in_part(s, ray);
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
            s = turn_in_part(s, ray);
            turns -= 1;
#ifdef GRID
            if (grid_entered > most_elements) turns = 0;
#endif
#endif
        } while (turns > 0 && s.phase != PHASE_DONE);
    }
    return s;
}

#ifndef SECTIONS
RayState begin(Ray ray) {
    return begin_part(ray);
}

RayState march(Ray ray, RayState s) {
    return march_part(ray, s);
}
#endif
