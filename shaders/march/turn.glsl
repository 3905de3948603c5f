#ifdef BOUNDS_PIECES
// One turn of a method that bounds F over the piece [low, high] of the ray and samples it at a
// point of the piece: next_sample() chooses it, advance() continues from there. Every method first
// samples where the ray begins. While the ray refines its root, the piece is a point.
RayState turn(RayState s, Ray ray) {
    bool starts = s.phase == PHASE_START, refines = s.phase == PHASE_REFINE;
    bool isolates = s.phase == PHASE_MARCH;
    if (starts && !(s.high > s.low)) s.high = min(s.low + limits.w, ray.t_far);
    float t = isolates ? next_sample(s) : refines ? s.f_low.y : s.low;
    vec2 piece = starts || isolates ? vec2(s.low, s.high) : vec2(t);
#ifdef LISTS
    choose_list(max(piece.y, t));
#endif
    float f = field(ray_point(ray, t));
    Bounds bounds = bounds_over(ray, piece, sample_direction(s, ray));
    s.evaluations += 1;
    float slope = 0.5 * (bounds.derivative.x + bounds.derivative.y);
    if (s.phase == PHASE_GRADIENT) return take_derivative(s, vec2(f, slope));
    if (im_is_nan(f)) return no_value(s, ray);
    if (refines) return refine(s, t, f, slope);
    // Samples in gaps of F may be numbers, such as those of min(log(x), 3).
    if (!excludes_0(bounds.value) && has_no_value(ray, piece)) return pass_break(s, ray);
#ifdef WALLS
    if (starts && is_wall(s, f)) return found(s, t);
#endif
    if (starts) return step_by_derivative(s, ray, f, bounds);
    return advance(s, ray, t, f, bounds);
}
#else
// One turn of a method that samples points of the ray: next_sample() chooses the point, advance()
// continues from there.
RayState turn(RayState s, Ray ray) {
    float t = next_sample(s);
#ifdef LISTS
    choose_list(t);
#endif
    vec2 f = sample_field(ray_point(ray, t), sample_direction(s, ray));
    return advance(s, ray, t, f);
}
#endif
