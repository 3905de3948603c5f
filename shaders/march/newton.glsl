// Newton's steps to the root of a settled ray, from a guess in its slab [t_near, t_far]. All slopes of F
// there are within a fifth of one, so that each step at least halves the distance to the root:
// beam_by_models.frag. What is beyond an end is farther from the root than the end.
RayState step_by_newton(RayState s, Ray ray, float t, vec2 f) {
    s.high = clamp(t - f.x / f.y, ray.t_near, ray.t_far);
    bool close = abs(s.high - t) <= 4.0 * cubics.w;
    if (close) return found(s, s.high);
    if (s.evaluations >= int(limits.y)) return finish(s, VERDICT_STEP_LIMIT);
    return s;
}
