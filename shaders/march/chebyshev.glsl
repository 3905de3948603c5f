// Finds the first root of polynomials F in x, y and z. Along the ray F is a polynomial in t, known
// from DEGREE + 1 samples. Its first root is approached from the left: the polynomial is split
// where the polygon of its Bernstein coefficients first meets 0 (Morken & Reimers 2007). A left
// part without sign changes is passed, a part with one isolates the root, and a left part with more
// is split closer. Samples of F at the root, and Newton steps, then remove the rounding of the
// coefficients.
//
// Rounding errs by about NOISE times the largest coefficient. A value that near to 0 counts as 0,
// so that roots which F only touches are found, if a sample of F agrees. If it does not, the rest
// of the ray is sampled anew, more accurately since it is shorter. A ray that has taken the samples
// of MOST_PIECES is given up as a miss.

const float NOISE = 4.0 * 5.9604645e-8;
const int MOST_SPLITS = 32;
const int MOST_NEWTON_STEPS = 3;
const int MOST_PIECES = 6;

float next_sample(RayState s) {
    return s.high;
}

RayState take_sample(RayState s, Ray ray, float f) {
    for (int k = 0; k < DEGREE; ++k) s.samples[k] = s.samples[k + 1];
    s.samples[DEGREE] = f;
    s.taken += 1;
    s.high = s.low + sample_place(s.taken) * (ray.t_far - s.low);
    s.phase = s.taken > DEGREE ? PHASE_SOLVE : PHASE_START;
    return s;
}

// Refines a root of the polynomial, where it has the slope f_low.y. f_low.x is the value that
// counts as 0, with the sign of F before the root.
RayState refine(RayState s, Ray ray, float t, float f) {
    float level = abs(s.f_low.x);
    float value = s.f_low.x < 0.0 ? -f : f;
    float newton = t - f / s.f_low.y;
    bool inside = newton >= s.low && newton <= ray.t_far;
    float root = inside ? newton : t;
    s.taken += 1;
    bool last = s.taken >= MOST_NEWTON_STEPS || !inside;
    // Also stops at a step that floats hardly tell from none.
    bool stands = abs(newton - t) <= 1.0e-6 * abs(ray.t_far - ray.t_near);
    // Samples err less than coefficients.
    if (abs(value) <= 0.0625 * level || stands || (last && value < 0.0)) return found(s, root);
    s.high = root;
    if (!last) return s;
    // No root here: samples the rest of the ray.
    s.low = t;
    s.high = t;
    s.taken = 0;
    s.phase = PHASE_START;
    // For shadow rays, evaluations include those of all lights up to this one.
    bool gives_up = s.evaluations > MOST_PIECES * (DEGREE + 2) * (s.refinements + 1);
    if (t < ray.t_far && !gives_up) return s;
    return finish(s, VERDICT_MISS);
}

RayState advance(RayState s, Ray ray, float t, vec2 f) {
    s.evaluations += 1;
    if (s.phase == PHASE_GRADIENT) return take_derivative(s, f);
    if (im_is_nan(f.x)) return finish(s, VERDICT_NAN);
    if (s.phase == PHASE_REFINE) return refine(s, ray, t, f.x);
    return take_sample(s, ray, f.x);
}

RayState solve(RayState s, Ray ray) {
    float b[DEGREE + 1], left[DEGREE + 1], right[DEGREE + 1];
    to_bernstein(s.samples, b);
    float upright = b[0] < 0.0 ? -1.0 : 1.0, largest = 0.0;
    for (int i = 0; i <= DEGREE; ++i) largest = max(largest, abs(b[i]));
    // A ray that begins near the surface has no root there yet.
    float level = min(NOISE * largest, 0.5 * abs(b[0]));
    for (int i = 0; i <= DEGREE; ++i) b[i] = upright * b[i] - level;

    Changes changes = sign_changes(b);
    float begins = 0.0, width = 1.0, u = changes.first, at = 0.0, slope = 0.0;
    bool searches = s.phase == PHASE_SOLVE && changes.count > 0;
    bool isolated = changes.count == 1, is_there = false;
    int turns = MOST_SPLITS;
    do {
        right = b;
        vec2 p = split(right, left, u);
        Changes before = sign_changes(left), after = sign_changes(right);
        float step = -p.x / p.y * width;
        at = begins + u * width;
        slope = p.y / width;
        turns -= 1;
        bool near = isolated && abs(step) < 1.0 / 256.0 || abs(p.x) < level || turns == 0;
        if (near) at = clamp(at + step, begins, begins + width);
        bool goes_right = before.count == 0;
        bool goes_left = before.count == 1;
        for (int i = 0; i <= DEGREE; ++i) b[i] = goes_right ? right[i] : goes_left ? left[i] : b[i];
        begins += goes_right ? u * width : 0.0;
        width *= goes_right ? 1.0 - u : goes_left ? u : 1.0;
        is_there = is_there || searches && near; // llvmpipe lost it in rays that ended early
        searches = searches && !near && !(goes_right && after.count == 0);
        isolated = isolated || goes_left || goes_right && after.count == 1;
        u = goes_right ? after.first : goes_left ? before.first : u * before.first;
    } while (searches);

    if (s.phase != PHASE_SOLVE) return s;
    if (!is_there) return finish(s, VERDICT_MISS);
    float reach = ray.t_far - s.low;
    s.high = s.low + at * reach;
    s.f_low = vec2(upright * level, upright * slope / reach);
    s.taken = 0;
    s.phase = PHASE_REFINE;
    if (s.evaluations >= int(limits.y)) return finish(s, VERDICT_STEP_LIMIT);
    return s;
}
