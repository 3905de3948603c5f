// Sphere tracing with bounds on the slope ahead (Hart 1996; Galin et al. 2020). A step is as long
// as F certainly stays away from 0, and the length of the bounded piece follows the step. Where a
// ray can move by less than the shortest piece, that is the root.

float next_sample(RayState s) {
    return s.low;
}

RayState advance(RayState s, Ray ray, float t, float f, Bounds bounds) {
    float finest = finest_at(t);
    // Only rounding can step over a root.
    bool over = (f < 0.0) != (s.f_low.x < 0.0);
    float step = safe_step(s, f, bounds);
    bool touches = s.high - s.low <= 4.0 * finest && step < min(finest, s.high - s.low);
    if (over) return found(s, t);
    if (touches) return touches_at(s, ray, t + step, bounds);
    return step_by_derivative(s, ray, f, bounds);
}
