// The section on whose cap a ray ended, or -1. Needs state.glsl.
int cap_of(RayState s) {
    bool is_cap = s.phase == PHASE_DONE && s.verdict == VERDICT_HIT && s.refinements < 0;
    return is_cap ? -1 - s.refinements : -1;
}
