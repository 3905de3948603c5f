// Needs state.glsl.
RayState finish(RayState s, int verdict) {
    s.phase = PHASE_DONE;
    s.verdict = verdict;
    return s;
}
