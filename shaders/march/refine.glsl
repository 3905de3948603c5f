// Pieces over which a ray is bounded: their lengths, roots in them, and places where F breaks.

// The lengths of the pieces over which a ray is bounded.

// The shortest piece at t: a part of a pixel, and at least 4 floats.
float finest_at(float t) {
    return max(limits.z, 4.76837158e-7 * abs(t));
}

// Shortens the piece to this length.
RayState cut(RayState s, float length) {
    s.high = s.low + length;
    bool gives_up = s.evaluations >= int(limits.y) || !(s.high > s.low);
    if (gives_up) return finish(s, VERDICT_STEP_LIMIT);
    return s;
}

#ifndef ROUGH
// Common part of the methods that bound F over pieces. In the ray's state, [low, high] is the
// piece, f_low.x a value of F with the sign before the piece, and f_low.y the next sample of a ray
// that refines its root.

// Moves on to t, where F has the sign of f and before which there is no root; `length`: next piece.
RayState move_on(RayState s, Ray ray, float t, float f, float length) {
    s.phase = PHASE_MARCH;
    s.low = t;
    s.f_low.x = f;
    s.high = min(t + max(length, finest_at(t)), ray.t_far);
    if (t >= ray.t_far) return finish(s, VERDICT_MISS);
    bool gives_up = s.evaluations >= int(limits.y) || !(s.high > s.low);
    if (gives_up) return finish(s, VERDICT_STEP_LIMIT);
    return s;
}

// Distance from `low`, where F is f, before which F cannot be 0: |f| over the rate at which it can
// fall within the piece. The whole piece if it has no root.
float safe_step(RayState s, float f, Bounds bounds) {
    float fall = f < 0.0 ? bounds.derivative.y : -bounds.derivative.x;
    float length = s.high - s.low;
    float within = fall < IM_LARGEST ? min(abs(f) / fall, length) : 0.0;
    return fall <= 0.0 || excludes_0(bounds.value) ? length : within;
}

RayState step_by_derivative(RayState s, Ray ray, float f, Bounds bounds) {
    float h = s.high - s.low, step = safe_step(s, f, bounds);
    bool free = step >= h;
    // Short pieces have tight bounds.
    float next = free ? 2.0 * h : clamp(2.0 * step, 0.25 * h, h);
    return move_on(s, ray, free ? s.high : s.low + step, f, next);
}

// Begins to refine a root: F changes its sign in [low, high], at about `guess`.
RayState isolated(RayState s, float low, float high, float guess) {
    s.low = low;
    s.high = high;
    s.f_low.y = guess > low && guess < high ? guess : 0.5 * (low + high);
    s.refinements = 0;
    s.phase = PHASE_REFINE;
    return s;
}

// Takes Newton's step if it stays between the ends, and halves the interval every fourth time.
RayState refine(RayState s, float t, float f, float slope) {
    if ((f < 0.0) == (s.f_low.x < 0.0)) s.low = t;
    else s.high = t;
    s.refinements += 1;
    float newton = t - f / slope;
    bool inside = newton >= s.low && newton <= s.high;
    bool close = inside && abs(newton - t) <= 4.0 * finest_at(t);
    bool narrow = s.high - s.low <= finest_at(t) || s.refinements >= 32;
    s.f_low.y = inside && (close || (s.refinements & 3) != 0) ? newton : 0.5 * (s.low + s.high);
    if (close || narrow) return found(s, s.f_low.y);
    return s;
}
#endif

#ifdef BREAKS
// Finds where F may jump, have a pole or lack a value. No root is there, whatever its sign does.
// Methods that bound F pass the shortest piece around such a point, and restart behind it.

// (jumps, without value): the first interval is the entire line if F may not be continuous; the
// second is above 0 if F has no value anywhere in the piece, or no zero beside its poles.
vec4 breaks_over(Ray ray, vec2 piece) {
    vec2 x, y, z;
    box_over(ray, piece, x, y, z);
    return field_breaks(x, y, z);
}

bool may_break(Ray ray, vec2 piece) {
    return !(breaks_over(ray, piece).x > -IM_LARGEST);
}

bool has_no_value(Ray ray, vec2 piece) {
    return breaks_over(ray, piece).z > 0.0;
}
#else
// For F that is continuous and has a value everywhere, by its operations.

bool may_break(Ray ray, vec2 piece) {
    return false;
}

bool has_no_value(Ray ray, vec2 piece) {
    return false;
}
#endif
