// Sphere tracing with bounds on the slope ahead (Hart 1996; Galin et al. 2020). From its value at
// `low` F comes to 0 no sooner than after |F| over the rate at which it can fall within the piece;
// where that is beyond the piece, there is no root in it. The piece follows the step: short ones
// have close bounds. Where the ray can go less than `finest`, that is the root.

float next_sample(RayState s) {
    return s.low;
}

RayState advance(RayState s, Ray ray, float t, float f, Bounds bounds) {
    if (im_is_nan(f)) return finish(s, VERDICT_NAN);
    float finest = refinement.z;
    // Only rounding can step over a root.
    if ((f < 0.0) != (s.f_low.x < 0.0)) return found(s, t);
    float h = s.high - s.low;
    float fall = f < 0.0 ? bounds.slope.y : -bounds.slope.x;
    bool climbs = fall <= 0.0;
    float reach = climbs ? h : fall < IM_LARGEST ? abs(f) / fall : 0.0;
    if (reach >= h || excludes_0(bounds.value)) return move_on(s, ray, s.high, f, 2.0 * h);
    if (h <= 4.0 * finest && reach <= finest) return found(s, t + reach);
    return move_on(s, ray, t + reach, f, clamp(2.0 * reach, 0.25 * h, h));
}
