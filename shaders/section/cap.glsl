// Ends a ray on the cap of a section; cap_of() returns that section, or -1. Needs state.glsl.

RayState end_on_cap(RayState s, float t, int section) {
    s.low = t;
    s.refinements = -1 - section;
    return finish(s, VERDICT_HIT);
}

int cap_of(RayState s) {
    bool is_cap = s.phase == PHASE_DONE && s.verdict == VERDICT_HIT && s.refinements < 0;
    return is_cap ? -1 - s.refinements : -1;
}
