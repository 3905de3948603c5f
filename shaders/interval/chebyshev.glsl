// im_chebyshev, im_chebyshev_stopped, im_chebyshev_slope, im_chebyshev_steep on intervals. Needs
// arithmetic.glsl, exp.glsl, trig.glsl, divide.glsl, inverse_trig.glsl, inverse_hyperbolic.glsl.
//
// T_n(cos h) = cos(n h), T_n(cosh t) = cosh(n t), degree n >= 2; intervals of angles hold their
// error.

// Joins the values `inside` [-1, 1] with those beyond: `low` at |a.x| and `high` at |a.y|. `even`:
// values at -x equal those at x; otherwise they are negated.
vec2 im_with_outside(vec2 a, vec2 inside, vec2 low, vec2 high, bool even) {
    vec2 left = IM_SELECT2(even, low, -low.yx);
    vec2 left_inner = IM_SELECT2(even, high, -high.yx);
    if (a.x > 1.0) return vec2(low.x, high.y);
    if (a.y < -1.0) return vec2(min(left.x, left_inner.x), max(left.y, left_inner.y));
    inside = IM_SELECT2(a.y > 1.0, vec2(min(inside.x, high.x), max(inside.y, high.y)), inside);
    return IM_SELECT2(a.x < -1.0, vec2(min(inside.x, left.x), max(inside.y, left.y)), inside);
}

vec2 im_chebyshev(int n, vec2 a) {
    float degree = float(n);
    vec2 inside = im_cos(im_scale_up(degree, im_acos(clamp(a, -1.0, 1.0))));
    if (max(-a.x, a.y) <= 1.0) return inside;
    vec2 low = im_cosh(im_scale_up(degree, im_acosh(vec2(abs(a.x)))));
    vec2 high = im_cosh(im_scale_up(degree, im_acosh(vec2(abs(a.y)))));
    return im_with_outside(a, inside, low, high, (n & 1) == 0);
}

// For high degrees: evaluation stops arguments at +-reach, so values stop at about +-stop. The
// interval holds these values and the exact ones.
vec2 im_chebyshev_stopped(int n, float reach, float stop, vec2 a) {
    vec2 r = im_chebyshev(n, a);
    vec2 right = vec2(0.5 * stop, 2.0 * stop);
    vec2 left = IM_SELECT2((n & 1) == 0, right, -right.yx);
    r = IM_SELECT2(a.y < reach, r, vec2(min(r.x, right.x), max(r.y, right.y)));
    return IM_SELECT2(a.x > -reach, r, vec2(min(r.x, left.x), max(r.y, left.y)));
}

// Encloses sin h for x = cos h. The differences are exact where sin h is small.
vec2 im_sine_of_cosine(float x) {
    precise vec2 factors = vec2(1.0 - x, 1.0 + x);
    precise float square = factors.x * factors.y;
    precise float r = sqrt(square);
    precise float margin = r * 9.53674316e-7;
    precise vec2 result = vec2(r - margin, r + margin);
    return result;
}

// T_n'(x) = n sin(n h) / sin h at a point x of [-1, 1], at most n^2.
vec2 im_slope_inside(float degree, float x) {
    vec2 sines = im_sin(im_scale_up(degree, im_acos(vec2(x))));
    vec2 slope = im_scale_up(degree, im_divide(sines, im_sine_of_cosine(x)));
    return clamp(slope, -degree * degree, degree * degree);
}

// T_n'(y) = n sinh(n t) / sinh t at a point y beyond 1, at least n^2.
vec2 im_slope_outside(float degree, float y) {
    vec2 t = im_acosh(vec2(y));
    vec2 slope = im_scale_up(degree, im_divide(im_sinh(im_scale_up(degree, t)), im_sinh(t)));
    return max(slope, vec2(degree * degree));
}

// T_n' at a point y >= 0.
vec2 im_slope_at(float degree, float y) {
    vec2 inside = im_slope_inside(degree, min(y, 1.0));
    vec2 outside = im_slope_outside(degree, y);
    return IM_SELECT2(y <= 1.0, inside, outside);
}

vec2 im_chebyshev_slope(int n, vec2 a) {
    float degree = float(n);
    bool even = (n & 1) == 1;
    vec2 low_end = im_slope_at(degree, abs(a.x));
    vec2 high_end = im_slope_at(degree, abs(a.y));
    // Beyond the last extremum of T_n, at cos(pi / n), T_n' rises from 0.
    float edge = im_cos(3.14159274 / degree) + 1.0e-6;
    if (a.x >= edge) return vec2(low_end.x, high_end.y);
    if (a.y <= -edge) {
        vec2 mirrored = vec2(high_end.x, low_end.y);
        return IM_SELECT2(even, mirrored, -mirrored.yx);
    }
    vec2 inner = clamp(a, -1.0, 1.0);
    vec2 sines = im_sin(im_scale_up(degree, im_acos(inner)));
    vec2 low = im_sine_of_cosine(inner.x);
    vec2 high = im_sine_of_cosine(inner.y);
    // sin h is largest at x = 0 and falls to both sides.
    vec2 size = vec2(min(low.x, high.x),
                     IM_SELECT(a.x <= 0.0 && a.y >= 0.0, 1.0, max(low.y, high.y)));
    vec2 slope = im_scale_up(degree, im_divide(sines, size));
    slope = clamp(slope, -degree * degree, degree * degree);
    if (max(-a.x, a.y) <= 1.0) return slope;
    return im_with_outside(a, slope, low_end, high_end, even);
}

// Bounds a higher derivative, whose largest size in [-1, 1] is `bound`, its value at 1.
vec2 im_chebyshev_steep(float bound, vec2 a) {
    return IM_SELECT2(max(-a.x, a.y) <= 1.0, vec2(-bound, bound), IM_ENTIRE);
}
