// Error-controlled cubic marching. F and dF/dt at both ends of a step define a cubic. A third
// sample, outside of the step, measures how far F is from the cubic, since cubic interpolation errs
// by a multiple of (t - t0)^2 (t - t1)^2. If the cubic stays farther from 0 than this error, the
// step has no root; the farther it stays, the longer the next step. If F changes its sign and the
// cubic has one root, that is the root. In doubt the step is cut where the cubic is nearest to 0.
// So roots that F only touches are found too, at a price that grows with the logarithm of how
// nearly F touches 0.
//
// `thresholds.x` is the longest first step, whose error nothing measures.
//
// Software renderers execute both sides of a branch, so there is none. With BRANCHES, graphics cards
// skip what no ray of a group needs.
#ifdef BRANCHES
#define WHERE(condition) if (condition)
#else
#define WHERE(condition)
#endif

// Returns the zero of F as a part of h, in (0, 1), if t is a cubic of F; f0 and f1 differ in sign.
float inverse_cubic(vec2 f0, vec2 f1, float h) {
    float rise = f1.x - f0.x;
    float u = -f0.x / rise, v = 1.0 - u;
    float x = u * u * (3.0 - 2.0 * u) + u * v * (rise / h) * (v / f0.y - u / f1.y);
    return x > 0.0 && x < 1.0 ? x : clamp(u, 0.01, 0.99);
}

// Advances a ray by its sample at t: F and dF/dt are f. The ray `starts` there, or `refines` a root,
// or neither: constants, where each has its own way, leave out what the others take.
RayState advance_by_cubic(RayState s, Ray ray, float t, vec2 f, float longest, bool starts,
                          bool refines) {
    float safety = cubics.x, finest = cubics.w;
    bool nan = im_is_nan(f.x);
    RayState before = s;
    // A NaN slope counts as 0, as at a kink; where F is smooth, it comes of infinite numbers.
    bool no_slope = im_is_nan(f.y);
    if (no_slope) f.y = 0.0;
    float newton = t - f.x / f.y;
#ifndef ROUGH
    if (no_slope) f.y = uintBitsToFloat(0x7f800000u);
#endif
    bool same_side = (f.x < 0.0) == (s.f_low.x < 0.0);

    // The cubic f0 + y (m0 + y (c2 + (y - h) c3)) from y = 0 to h.
    float f0 = s.f_low.x, m0 = s.f_low.y;
    float h = t - s.low, per_h = 1.0 / h;
    float mean = (f.x - f0) * per_h;
    float c2 = (mean - m0) * per_h;
    float c3 = (f.y + m0 - 2.0 * mean) * per_h * per_h;
    // The cubic's error in the middle. Without a third sample it is unknown: the term of third degree
    // tells nothing where F is even about the middle, as the distance to a ball is.
    float o = s.other.x - s.low, p = s.other.x - t;
    float off = f0 + o * (m0 + o * (c2 + p * c3)) - s.other.y;
    float bend = m0 + o * (2.0 * c2 + (o + 2.0 * p) * c3) - s.other.z;
    float scale = 0.25 * h * h / (o * p);
    float measured = scale * scale * (abs(off) + abs(0.5 * bend * o * p / (o + p)));
    float guessed = h * h * (abs(c3) * h + 0.03125 * abs(c2));
    float error = o == 0.0 ? guessed : safety * measured;

    // The cubic's minimum if F > 0 at 0, otherwise its maximum.
    float upright = f0 < 0.0 ? -1.0 : 1.0;
    float a = upright * 3.0 * c3, b = upright * (c2 - h * c3), c = upright * m0;
    float root = sqrt(max(b * b - a * c, 0.0));
    float y = (b > 0.0 ? -c : root - b) / (b > 0.0 ? b + root : a);
    bool dips = y > 0.0 && y < h;
    y = dips ? y : 0.5 * h;
    float least = upright * (f0 + y * (m0 + y * (c2 + (y - h) * c3)));
    float in_step = 4.0 * y * (h - y) * per_h * per_h;
    // Displacement of a sample by rounding. Only this keeps an exact cubic off a double root.
    float rounding = cubics.z;
    bool clear = least > error * in_step * in_step + 0.25 * rounding * max(abs(m0), abs(f.y));
#ifdef ROUGH
    // Samples don't tell how sharp the bend between them is, as of the distance to a thin rod.
    clear = clear && least_between(upright * f0, upright * f.x, upright * vec2(m0, f.y), h) > 0.0;
#endif
    float middle = upright * (0.5 * (f0 + f.x) + 0.125 * h * (m0 - f.y));

    bool is_finest = h <= finest;
    // Infinite values and slopes tell no cubic; a smooth F is far from 0 there. So it is where values
    // are cut off (IM_SATURATION), whose slopes go on.
    bool cut_off = mean == 0.0 && m0 * f.y > 0.0 && abs(m0) * h > 1.0e-5 * abs(f0);
    bool overflows = cut_off || min(abs(f0), abs(f.x)) > IM_LARGEST;
#ifndef ROUGH
    overflows = overflows || min(abs(m0), abs(f.y)) > IM_LARGEST || is_finest && !(error <= IM_LARGEST);
#endif
    bool is_clear = clear && middle > error || overflows;
    bool free = same_side && is_clear && !refines && !starts;
    bool fits = error < 0.5 * max(abs(f0), abs(f.x));
    bool isolated =
        !same_side && !refines && !starts && (is_finest || (clear || !dips) && fits);
    // A sample on a double root leaves no root inside the steps beside it. The finest steps say
    // nothing of curvature.
    float touching = h > finest ? 4.0 * abs(c2 + 2.0 * h * c3) * rounding * rounding : 0.0;
    bool on_root = fits && touching <= IM_LARGEST && abs(f.x) <= touching;
    bool touches = same_side && (on_root || !free && is_finest) && !refines && !starts;
#ifdef BOUNDED_TOUCHES
    // The step goes on as if F did not touch 0; solve() asks bounds whether it may.
    free = free || touches && is_finest;
#endif
    bool closes_in = isolated || refines;
    bool moves = starts || free || refines && same_side;

    // The interval in which F changes its sign, if it does: on one side of the sample or the other.
    bool beyond = refines && same_side;
    float begins = beyond ? t : s.low, ends = beyond ? s.other.x : t;
    vec2 first = beyond ? f : s.f_low, last = beyond ? s.other.yz : f;
    float halfway = begins + 0.5 * (ends - begins), between = halfway;
    WHERE (closes_in) {
        float part = inverse_cubic(first, last, ends - begins);
        // Halves the interval now and then, so that kinks and noise in slopes cost little.
        between = (s.refinements & 3) == 2 ? halfway : begins + part * (ends - begins);
        between = between > begins && between < ends ? between : halfway;
    }

    float growth = min(middle, abs(f.x)) > 8.0 * error || overflows ? 2.5 : 1.2;
    // Newton's step from beside a surface that the ray leaves is to what is behind it, and far shorter
    // than it need be. Yet small waves may be there that no line of the probe met: in 27 scenes of such
    // waves first steps of a sixteenth miss no more roots than Newton's, those of a tenth miss some.
    bool recedes = (f.x < 0.0) == (f.y < 0.0);
    float least_step = recedes ? 0.03125 * thresholds.x : 0.0;
    float first_step = max(min(abs(t - newton), thresholds.x), least_step);
    float step = starts ? first_step : growth * h;
#ifdef ROUGH
    // Behind a break, whose length `other` holds, more may follow. Far from 0 steps grow fast.
    if (starts && s.other.x > 0.0) step = min(step, 8.0 * s.other.x);
    if (!starts && min(middle, abs(f.x)) > 800.0 * error) step = 8.0 * h;
#endif
    float forward = min(t + clamp(step, finest, longest), ray.t_far);
    float cut = s.low + clamp(y, 0.1 * h, 0.9 * h);
    float next = closes_in ? between : moves ? forward : cut;
    // Newton's step errs by the change of the slope on its way. The slopes at both ends and of the
    // chord between give that change: an inflection has the same slope on both sides.
    float chord = (last.x - first.x) / (ends - begins);
    float unlike = max(abs(last.y - first.y), 2.0 * abs(f.y - chord));
    float change = 0.5 * (newton - t) * unlike / (f.y * (ends - begins));
    bool small = abs(newton - t) <= 4.0 * finest || abs((newton - t) * change) <= 0.0625 * finest;
    bool close = refines && small && newton >= begins && newton <= ends;
    bool narrow = refines && (ends - begins <= finest || s.refinements >= 32) ||
                  closes_in && !(between > begins && between < ends);
    bool left = !closes_in && moves && t >= ray.t_far;

    if (!(refines && same_side)) s.other = free ? vec3(s.low, s.f_low) : vec3(t, f);
    if (moves) s.low = t;
    if (moves) s.f_low = f;
    s.high = next;
    s.refinements = refines ? s.refinements + 1 : 0;
    s.phase = closes_in ? PHASE_REFINE : PHASE_MARCH;
#ifdef ROUGH
    if (touches) return doubt_touch(before, t);
    if (free) s = pass_cubic(s, before, ray, t);
#endif
    if (nan) return finish(s, VERDICT_NAN);
    if (close) return found(s, newton);
    if (narrow) return found(s, clamp(between, begins, ends));
#ifdef BOUNDED_TOUCHES
    if (touches) return doubt_touch(s, on_root ? t : cut);
#else
    if (touches) return found(s, on_root ? t : cut);
#endif
    if (left) return finish(s, VERDICT_MISS);
    // A step below the spacing of floats would stand still.
    bool stands = !(s.high > s.low) || s.evaluations >= int(limits.y);
    if (stands) return finish(s, VERDICT_STEP_LIMIT);
    return s;
}

// Samples of a ray that marches by cubics. Rays of a group mostly begin, step or close in
// together: with BRANCHES each of the three goes its own way, without what the others take.

float next_sample(RayState s) {
    return s.high;
}

RayState advance(RayState s, Ray ray, float t, vec2 f) {
    float longest = clamp(0.25 * (ray.t_far - ray.t_near), cubics.w, cubics.y);
    s.evaluations += 1;
    if (s.phase == PHASE_GRADIENT) return take_derivative(s, f);
#ifdef SETTLES
    if (s.phase == PHASE_NEWTON) return step_by_newton(s, ray, t, f);
#endif
#ifdef ROUGH
    if (judge_by_intervals(s, ray, t, f, longest)) return s;
#endif
#ifdef BRANCHES
    if (s.phase == PHASE_START) return advance_by_cubic(s, ray, t, f, longest, true, false);
    if (s.phase == PHASE_REFINE) return advance_by_cubic(s, ray, t, f, longest, false, true);
    return advance_by_cubic(s, ray, t, f, longest, false, false);
#else
    bool starts = s.phase == PHASE_START, refines = s.phase == PHASE_REFINE;
    return advance_by_cubic(s, ray, t, f, longest, starts, refines);
#endif
}
