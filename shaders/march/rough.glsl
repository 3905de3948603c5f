// Keeps cubics right where F isn't smooth. Over each piece between two samples, intervals decide
// whether there may be a kink, a jump or a pole. If so, bounds of F and dF/dt over the piece judge
// the step, as in interval.glsl; otherwise cubics do.
//
// A piece that bounds leave open is halved. The rest of it is halved again, as long as at most one
// part in a row passes. So breaks are closed in on at one sample per bit. While a ray marches,
// `refinements` counts the parts passed, or says that bounds alone may judge.
const int BY_BOUNDS = 64;

// Leaves the piece up to t open.
RayState leave_open(RayState s, float t) {
    s.open_end = t;
    s.refinements = s.refinements == BY_BOUNDS ? BY_BOUNDS : 0;
    return cut(s, 0.5 * (t - s.low));
}

// Returns the end of the next piece, which begins at t and could have this length.
float next_end(RayState s, Ray ray, float t, float length) {
    float rest = s.open_end - t, part = s.refinements < 2 ? 0.5 * rest : rest;
    float most = rest > 0.0 ? min(length, max(part, finest_at(t))) : length;
    return min(t + most, ray.t_far);
}

// Handles a piece between the samples at s.low and t over which cubics take F for 0.
RayState doubt_touch(RayState s, float t) {
    s.refinements = BY_BOUNDS;
    s.other = vec3(s.low, s.f_low);
    s.high = t;
    return s;
}

// Moves on from t, after a cubic of the ray as it was `before` left no root up to there.
RayState pass_cubic(RayState s, RayState before, Ray ray, float t) {
    s.refinements = before.refinements + 1;
    s.high = next_end(s, ray, t, s.high - t);
    return s;
}

// Restarts the ray at t, since its samples before say nothing of what follows. `length`: of the
// piece to try where F has no value.
RayState begin_at(RayState s, Ray ray, float t, float length) {
    s.low = s.high = t;
    s.other = vec3(length, 0.0, 0.0);
    s.phase = PHASE_START;
    if (t >= ray.t_far) return finish(s, VERDICT_MISS);
    if (s.evaluations >= int(limits.y)) return finish(s, VERDICT_STEP_LIMIT);
    return s;
}

// Moves a ray that begins at s.low, where F is f, over a piece without a value, and tells whether it
// did. Behind a break, samples of such a piece may be numbers. The next piece is tried at twice the
// length, or this one at half of it.
bool passes_no_value(inout RayState s, Ray ray, vec2 f) {
    bool is_nan = im_is_nan(f.x), lacks_value = false;
    float finest = finest_at(s.low), length = max(s.other.x, finest);
    if (is_nan || s.other.x > 0.0) lacks_value = has_no_value(ray, vec2(s.low, s.low + length));
    if (!is_nan && !lacks_value) return false;
    if (lacks_value || length <= finest) s = begin_at(s, ray, s.low + length, 2.0 * length);
    else s = begin_at(s, ray, s.low, 0.5 * length);
    return true;
}

// Moves on to t, where F is f and before which there is no root.
RayState pass_piece(RayState s, Ray ray, float t, vec2 f, vec3 other) {
    s.refinements = s.refinements == BY_BOUNDS ? 0 : s.refinements + 1;
    float length = 2.0 * (t - s.low);
#ifdef SIGNS_IN_FREE_CELLS
    length = min(length, cubics.y); // tapes of longer pieces take longer than the pieces are
#endif
    s.high = next_end(s, ray, t, max(length, finest_at(t)));
    s.low = t;
    s.f_low = f;
    s.other = other;
    s.phase = PHASE_MARCH;
    if (t >= ray.t_far) return finish(s, VERDICT_MISS);
    bool gives_up = s.evaluations >= int(limits.y) || !(s.high > s.low);
    if (gives_up) return finish(s, VERDICT_STEP_LIMIT);
    return s;
}

// Lower bound of F over a piece of length h, from its positive values at both ends and its slopes.
float least_between(float at_begin, float at_end, vec2 slope, float h) {
    if (!(slope.x < 0.0)) return at_begin;
    if (!(slope.y > 0.0)) return at_end;
    if (!(slope.x > -IM_LARGEST) || !(slope.y < IM_LARGEST)) return -IM_LARGEST;
    return (slope.y * at_begin - slope.x * at_end + slope.x * slope.y * h) / (slope.y - slope.x);
}

// Judges the piece from the sample at s.low to that at t.
RayState advance_by_bounds(RayState s, Ray ray, float t, vec2 f) {
    float h = t - s.low;
    bool is_finest = h <= finest_at(t);
    bool lacks_value = im_is_nan(f.x);
    if (lacks_value && is_finest) return begin_at(s, ray, t, h);
    Bounds bounds = bounds_over(ray, vec2(s.low, t), ray.direction);
    bool below = f.x < 0.0, changes = below != (s.f_low.x < 0.0);
    bool monotone = excludes_0(bounds.derivative);
    vec2 upright = below ? -bounds.derivative.yx : bounds.derivative;
    float least = least_between(abs(s.f_low.x), abs(f.x), upright, h);
    bool has_no_root = excludes_0(bounds.value) || !changes && (monotone || least > 0.0);
    if (has_no_root && !lacks_value) return pass_piece(s, ray, t, f, vec3(t, f));
    if (monotone && !lacks_value) {
        s.other = vec3(t, f);
        s.high = s.low + 0.5 * h;
        s.refinements = 0;
        s.phase = PHASE_REFINE;
        return s;
    }
    // Samples in gaps of F may be numbers, such as those of min(log(x), 3).
    if (has_no_value(ray, vec2(s.low, t))) return begin_at(s, ray, t, h);
    if (!is_finest) return leave_open(s, t);
    bool bounded = abs(bounds.value.x) < IM_LARGEST && abs(bounds.value.y) < IM_LARGEST;
#ifdef WALLS
    if (changes && bounded) return found(s, 0.5 * (s.low + t));
#endif
    if (may_break(ray, vec2(s.low, t))) return begin_at(s, ray, t, h);
    if (bounded) return found(s, 0.5 * (s.low + t));
    return finish(s, VERDICT_STEP_LIMIT);
}

// Returns whether intervals judged the piece up to the sample at t; s is the result. Leaves cubics
// no pieces longer than `longest`; pieces of bounds may be longer.
bool judge_by_intervals(inout RayState s, Ray ray, float t, vec2 f, float longest) {
    if (s.phase == PHASE_START) return passes_no_value(s, ray, f);
    if (s.phase != PHASE_MARCH) return false;
    vec2 x, y, z;
    box_over(ray, vec2(s.low, t), x, y, z);
    vec4 rough = field_rough(x, y, z);
    // Sums of zeros are rounded outwards.
    bool is_smooth = rough.z > -IM_LARGEST && rough.w < IM_LARGEST && s.refinements != BY_BOUNDS;
#ifdef SIGNS_IN_FREE_CELLS
    is_smooth = is_smooth && !tape_is_free && abs(s.f_low.x) > 1.0e-30; // a sign makes no cubic
#endif
    if (excludes_0(rough.xy) && !im_is_nan(f.x)) {
        vec3 behind = is_smooth ? vec3(s.low, s.f_low) : vec3(t, f);
        s = pass_piece(s, ray, t, f, behind);
        return true;
    }
    // Behind a piece that bounds judged there is no third sample, as where a ray begins.
    float most = s.other.x == s.low ? min(thresholds.x, longest) : longest;
    // After a cut the length is the same but for rounding.
    if (is_smooth && t - s.low <= 1.01 * most) return false;
    if (is_smooth) s = cut(s, most);
    else s = advance_by_bounds(s, ray, t, f);
    return true;
}
