// Error-controlled cubic marching. F and dF/dt at both ends of a step are a cubic; a third sample,
// outside of the step, tells how far F is from it, since cubic interpolation errs by a multiple of
// (t - t0)^2 (t - t1)^2. Where that error can't reach 0, there is no root: the next step is longer
// the farther off it was. Where F changes sign and the cubic has one root, that is the root. In
// doubt the step is cut where the cubic comes nearest to 0, so that also roots that F only touches
// are found, at a price that grows with the logarithm of how nearly it does.
//
// refinement.z: the finest step; refinement.w: the longest.

// How many times the estimated error a cubic must keep off 0.
const float SAFETY = 4.0;

float next_sample(RayState s) {
    return s.high;
}

// Where, as a part of the step, F is 0 if t is a cubic of F; the slopes are those of t by F there.
float inverse_cubic(float f0, float f1, float slope0, float slope1) {
    float u = f0 / (f0 - f1), v = 1.0 - u;
    float d = (f1 - f0);
    float x = u * u * (3.0 - 2.0 * u) + u * v * (d * v / slope0 - d * u / slope1);
    return x > 0.0 && x < 1.0 ? x : u;
}

// The root is between `low` and `other`; closes in on it.
RayState sample_between(RayState s) {
    float h = s.other.x - s.low;
    float part = inverse_cubic(s.f_low.x, s.other.y, h * s.f_low.y, h * s.other.z);
    // Every third time halves the interval: what a kink or noise does to slopes costs little.
    if (s.refinements % 3 == 2 || !(part > 0.0 && part < 1.0)) part = 0.5;
    s.high = s.low + part * h;
    s.phase = PHASE_REFINE;
    return s;
}

RayState refine(RayState s, float t, vec2 f) {
    bool same_side = (f.x < 0.0) == (s.f_low.x < 0.0);
    float before = same_side ? t : s.low, behind = same_side ? s.other.x : t;
    float by = f.x / f.y;
    s.refinements += 1;
    float root = t - by;
    bool inside = root >= before && root <= behind;
    if (inside && abs(by) <= 4.0 * refinement.z) return found(s, root);
    if (behind - before <= refinement.z || s.refinements >= 32) return found(s, 0.5 * (before + behind));
    if (same_side) {
        s.low = t;
        s.f_low = f;
    } else {
        s.other = vec3(t, f);
    }
    return sample_between(s);
}

// Goes on from `low` by h.
RayState step_on(RayState s, Ray ray, float h) {
    if (s.low >= ray.t_far) return finish(s, VERDICT_MISS);
    s.phase = PHASE_MARCH;
    s.high = min(s.low + clamp(h, refinement.z, refinement.w), ray.t_far);
    // A step below the spacing of floats would stand still.
    return s.high > s.low ? s : finish(s, VERDICT_STEP_LIMIT);
}

// One turn, F and dF/dt at t being f.
RayState advance(RayState s, Ray ray, float t, vec2 f) {
    s.evaluations += 1;
    if (im_is_nan(f.x)) return finish(s, VERDICT_NAN);
    if (s.phase == PHASE_GRADIENT) return take_slope(s, f);
    if (im_is_nan(f.y)) f.y = 0.0;
    if (s.phase == PHASE_REFINE) return refine(s, t, f);
    if (s.evaluations >= int(refinement.y)) return finish(s, VERDICT_STEP_LIMIT);
    if (s.phase == PHASE_START) {
        s.low = t;
        s.f_low = f;
        s.other = vec3(t, f);
        return step_on(s, ray, abs(f.x / f.y));
    }
    float h = t - s.low;
    // The cubic f0 + x (c1 + x (c2 + x c3)), x from 0 to 1, where F is positive at 0.
    float upright = s.f_low.x < 0.0 ? -1.0 : 1.0;
    float f0 = upright * s.f_low.x, f1 = upright * f.x;
    float c1 = upright * h * s.f_low.y, d1 = upright * h * f.y;
    float c2 = 3.0 * (f1 - f0) - 2.0 * c1 - d1;
    float c3 = 2.0 * (f0 - f1) + c1 + d1;
    float x = (s.other.x - s.low) / h;
    float weight = 0.25 / (x * (x - 1.0));
    float off = f0 + x * (c1 + x * (c2 + x * c3)) - upright * s.other.y;
    // In the middle of the step. Without a third sample nothing is known.
    float error = s.other.x == s.low ? 1.0e30 : SAFETY * abs(off) * weight * weight;

    // Its minimum, if it has one in the step.
    float root = sqrt(max(c2 * c2 - 3.0 * c1 * c3, 0.0));
    float least_at = c2 > 0.0 ? -c1 / (c2 + root) : (root - c2) / (3.0 * c3);
    bool dips = least_at > 0.0 && least_at < 1.0 && c1 < 0.0 || least_at > 0.0 && least_at < 1.0 && c2 + root > 0.0;
    if (!dips) least_at = 0.5;
    float least = f0 + least_at * (c1 + least_at * (c2 + least_at * c3));
    float near_ends = 4.0 * least_at * (1.0 - least_at);
    float least_error = error * near_ends * near_ends;
    float middle = f0 + 0.5 * (c1 + 0.5 * (c2 + 0.5 * c3));

    bool crosses = f1 <= 0.0;
    bool free = least > least_error && middle > error && !crosses;
    if (free) {
        s.other = vec3(s.low, s.f_low);
        s.low = t;
        s.f_low = f;
        float room = min(middle, f1);
        return step_on(s, ray, h * (room > 32.0 * error ? 2.0 : room > 4.0 * error ? 1.4 : 1.0));
    }
    bool finest = h <= refinement.z;
    bool single = (!dips || least > least_error) && error < 0.5 * max(f0, -f1);
    if (crosses && (single || finest)) {
        s.other = vec3(t, f);
        s.refinements = 0;
        return sample_between(s);
    }
    if (finest) return found(s, s.low + least_at * h);
    s.other = vec3(t, f);
    s.high = s.low + clamp(dips ? least_at : 0.5, 0.1, 0.9) * h;
    return s;
}
