// Decides by the first sample of a part whether it begins with a cap. turn_of_method() is the
// method's turn. march_by_samples.glsl sets where a part begins.
int cut_ahead = -1;   // the section on which it begins, or -1
float cut_at = 0.0;

RayState turn(RayState s, Ray ray) {
    RayState next = turn_of_method(s, ray);
    bool begins = cut_ahead >= 0 && s.phase == PHASE_START && s.low == cut_at;
    bool is_known = next.phase == PHASE_MARCH || next.phase == PHASE_DONE && next.verdict == VERDICT_MISS;
    if (begins && is_known && next.f_low.x < 0.0) return end_on_cap(next, cut_at, cut_ahead);
    return next;
}
