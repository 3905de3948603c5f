// What methods that bound F over pieces share. Of the state, [low, high] is the piece, f_low.x a
// value of F with the sign that it has before the piece, and f_low.y the next sample of a ray that
// closes in on its root.

// There is no root before t, where F has the sign of f: a piece of this length is next.
RayState move_on(RayState s, Ray ray, float t, float f, float length) {
    if (im_is_nan(f)) return finish(s, VERDICT_NAN);
    bool at_end = s.phase != PHASE_START && t >= ray.t_far;
    s.phase = PHASE_MARCH;
    s.low = t;
    s.f_low.x = f;
    s.high = min(t + max(length, refinement.z), ray.t_far);
    if (at_end) return finish(s, VERDICT_MISS);
    bool gives_up = s.evaluations >= int(refinement.y) || !(s.high > s.low);
    return gives_up ? finish(s, VERDICT_STEP_LIMIT) : s;
}

// The piece is to be shorter.
RayState cut(RayState s, float length) {
    s.high = s.low + length;
    bool gives_up = s.evaluations >= int(refinement.y) || !(s.high > s.low);
    return gives_up ? finish(s, VERDICT_STEP_LIMIT) : s;
}

// F changes its sign in [low, high]; `guess` is where.
RayState isolated(RayState s, float low, float high, float guess) {
    s.low = low;
    s.high = high;
    s.f_low.y = guess > low && guess < high ? guess : 0.5 * (low + high);
    s.refinements = 0;
    s.phase = PHASE_REFINE;
    return s;
}

// Newton's step where it stays between the ends, and every third time half of the interval.
RayState close_in(RayState s, float t, float f, float slope) {
    if (im_is_nan(f)) return finish(s, VERDICT_NAN);
    if ((f < 0.0) == (s.f_low.x < 0.0)) s.low = t;
    else s.high = t;
    s.refinements += 1;
    float newton = t - f / slope;
    bool inside = newton >= s.low && newton <= s.high;
    bool close = inside && abs(newton - t) <= 4.0 * refinement.z;
    bool narrow = s.high - s.low <= refinement.z || s.refinements >= 32;
    s.f_low.y = inside && (close || s.refinements % 3 != 0) ? newton : 0.5 * (s.low + s.high);
    return close || narrow ? found(s, s.f_low.y) : s;
}
