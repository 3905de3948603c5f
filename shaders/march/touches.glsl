// In the shortest piece, around t, nothing keeps F off 0: it is taken to be 0 unless it is beyond all
// bounds there.
RayState touches_at(RayState s, Ray ray, float t, Bounds bounds) {
    if (may_break(ray, vec2(s.low, s.high))) return pass_break(s, ray);
    bool bounded = abs(bounds.value.x) < IM_LARGEST && abs(bounds.value.y) < IM_LARGEST;
    return bounded ? found(s, t) : finish(s, VERDICT_STEP_LIMIT);
}
