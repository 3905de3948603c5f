// Of methods that bound F over the piece [low, high] of the ray and sample it at a point of the
// piece: next_sample() says which, advance() goes on from there. Where a ray closes in on its root
// the piece is that point.
RayState turn(RayState s, Ray ray) {
    bool isolating = s.phase == PHASE_MARCH;
    float t = s.phase == PHASE_REFINE ? s.f_low.y : next_sample(s);
    float f = field(ray_point(ray, t));
    vec2 piece = isolating ? vec2(s.low, s.high) : vec2(t);
    Bounds bounds = bounds_over(ray, piece, sample_direction(s, ray));
    s.evaluations += 1;
    float slope = 0.5 * (bounds.slope.x + bounds.slope.y);
    if (s.phase == PHASE_GRADIENT) return take_slope(s, vec2(f, slope));
    if (s.phase == PHASE_REFINE) return close_in(s, t, f, slope);
    if (s.phase == PHASE_START) return move_on(s, ray, ray.t_near, f, refinement.w);
    return advance(s, ray, t, f, bounds);
}
