// Decides the shortest pieces, and pieces where F has no value.

// Passes a piece in which F has no root whatever its sign does (refine.glsl).
RayState pass_break(RayState s, Ray ray) {
    s.refinements = 0;
    float h = s.high - s.low;
    s.low = s.high;
    s.high = min(s.low + max(2.0 * h, finest_at(s.low)), ray.t_far);
    s.phase = PHASE_START;
    if (s.low >= ray.t_far) return finish(s, VERDICT_MISS);
    bool gives_up = s.evaluations >= int(limits.y) || !(s.high > s.low);
    if (gives_up) return finish(s, VERDICT_STEP_LIMIT);
    return s;
}

#ifdef WALLS
// Whether the piece before, marked in `refinements`, holds a wall: a jump of bounded F, to f here.
bool is_wall(RayState s, float f) {
    return s.refinements == 1 && (f < 0.0) != (s.f_low.x < 0.0);
}
#endif

// Handles a piece at whose sample F is not a number.
RayState no_value(RayState s, Ray ray) {
    // Bounds prove F continuous there, so only float32 can have lost it.
    if (s.phase == PHASE_REFINE) return finish(s, VERDICT_NAN);
    float h = s.high - s.low;
    bool passes = h <= finest_at(s.low) || has_no_value(ray, vec2(s.low, s.high));
    if (passes) return pass_break(s, ray);
    return cut(s, 0.5 * h);
}

// Decides the shortest piece, around t, in which F may be 0: it counts as 0 unless F is unbounded
// there.
RayState touches_at(RayState s, Ray ray, float t, Bounds bounds) {
    bool bounded = abs(bounds.value.x) < IM_LARGEST && abs(bounds.value.y) < IM_LARGEST;
    if (may_break(ray, vec2(s.low, s.high))) {
        s = pass_break(s, ray);
        if (s.phase == PHASE_START) s.refinements = int(bounded);
        return s;
    }
    if (bounded) return found(s, t);
    return finish(s, VERDICT_STEP_LIMIT);
}
