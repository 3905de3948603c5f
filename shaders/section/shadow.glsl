// Crosses sections on shadow rays. Needs cross.glsl and any_hit(). `high` holds the section behind.

RayState at_shadow_crossing(RayState s, float t, int behind) {
    s.phase = PHASE_CROSS;
    s.low = t;
    s.high = float(behind);
    return s;
}

// The crossing as an eye's ray has it; a miss if the ray doesn't cross.
RayState crossing_of(RayState s, bool crosses) {
    RayState crossing = at_crossing(state_at(s.low), s.low, int(s.high));
    if (!crosses) return finish(crossing, VERDICT_MISS);
    return crossing;
}

int outcome_of(RayState crossing) {
    if (crossing.phase != PHASE_DONE) return RAY_GOES_ON;
    return crossing.verdict == VERDICT_HIT ? RAY_IS_HIDDEN : RAY_IS_FREE; // NaN at a cut: no cap
}

// State of a shadow ray where its next part begins; keeps what is known of lights, and the count of
// evaluations.
RayState on_part(RayState s, RayState crossing) {
    RayState fresh = state_at(crossing.low);
    fresh.verdict = s.verdict;
    fresh.evaluations = s.evaluations + crossing.evaluations;
    return fresh;
}
