// im_add, im_subtract, im_multiply, im_square, im_abs, im_unless_zero, im_select on intervals.
// Needs float32.glsl or float64.glsl.
//
// Intervals (lo, hi) are as in src/formula/interval/interval.h: lo <= hi, lo < infinity,
// hi > -infinity, no NaN; an infinite end is no bound, and 0 times an unbounded interval is 0. Ends
// are 0 or normal numbers, since drivers may flush subnormal ones to 0.
//
// Rounding outwards: a computed sum or product r is the number of p bits nearest to the exact
// value, so it is off by at most 2^-p |r|. A margin of 3/2 of that, IM_ROUNDING |r|, reaches a
// number at or beyond the exact value, see interval.h. Where the margin underflows, r may have been
// flushed to 0 if below 2^e. Errors are then at most 2^e, and IM_STEP = 2^(e+2) exceeds that and
// the flush of its own difference.

#define IM_ENTIRE REAL2(-IM_INFINITY, IM_INFINITY)

// Bounds of values that were computed as r, with errors of at most `relative` |r| or IM_STEP. A
// bound that overflowed inwards becomes the largest number.
REAL2 im_widen(REAL2 r, REAL relative) {
    precise REAL2 inner = REAL2(min(r.x, IM_LARGEST), max(r.y, -IM_LARGEST));
    precise REAL2 margin = abs(inner) * relative + IM_STEP;
    precise REAL2 outer = REAL2(inner.x - margin.x, inner.y + margin.y);
    return outer;
}

REAL2 im_outwards(REAL2 r) {
    return im_widen(r, IM_ROUNDING);
}

// Clips at 0 an interval of a quantity that is never negative in exact arithmetic.
REAL2 im_not_negative(REAL2 a) {
    return REAL2(max(a.x, 0.0), a.y);
}

// Beyond the saturation of floats, outer ends become infinite, and inner ends the saturation.
REAL2 im_saturate(REAL2 a) {
    return REAL2(IM_SELECT(a.x < -IM_SATURATION, -IM_INFINITY, min(a.x, IM_SATURATION)),
                 IM_SELECT(a.y > IM_SATURATION, IM_INFINITY, max(a.y, -IM_SATURATION)));
}

// The smallest and the largest distance from 0.
REAL2 im_abs(REAL2 a) {
    return REAL2(max(max(a.x, -a.y), 0.0), max(-a.x, a.y));
}

REAL2 im_add(REAL2 a, REAL2 b) {
    precise REAL2 r = a + b;
    return im_outwards(r);
}

REAL2 im_subtract(REAL2 a, REAL2 b) {
    precise REAL2 r = a - b.yx;
    return im_outwards(r);
}

// 0 times an infinite end is NaN in GLSL, but 0 by definition. The comparisons below drop NaN, and
// a product of two finite members takes its place. They are precise, so that none becomes a min().
REAL2 im_multiply(REAL2 a, REAL2 b) {
    precise REAL p = a.x * b.x;
    precise REAL q = a.x * b.y;
    precise REAL r = a.y * b.x;
    precise REAL s = a.y * b.y;
    precise REAL member = max(a.x, -IM_LARGEST) * max(b.x, -IM_LARGEST);
    precise REAL lo = IM_SELECT(p < member, p, member);
    lo = IM_SELECT(q < lo, q, lo);
    lo = IM_SELECT(r < lo, r, lo);
    lo = IM_SELECT(s < lo, s, lo);
    precise REAL hi = IM_SELECT(p > member, p, member);
    hi = IM_SELECT(q > hi, q, hi);
    hi = IM_SELECT(r > hi, r, hi);
    hi = IM_SELECT(s > hi, s, hi);
    return im_outwards(REAL2(lo, hi));
}

// For b >= 0: the lower end comes from a's lower end, the upper one from a's upper end.
REAL2 im_multiply_by_not_negative(REAL2 a, REAL2 b) {
    precise REAL2 inner = REAL2(max(a.x, -IM_LARGEST), min(a.y, IM_LARGEST)) * b.x;
    precise REAL2 outer = a * b.y;
    precise REAL lo = IM_SELECT(outer.x < inner.x, outer.x, inner.x);
    precise REAL hi = IM_SELECT(outer.y > inner.y, outer.y, inner.y);
    return im_outwards(REAL2(lo, hi));
}

REAL2 im_multiply_not_negative(REAL2 a, REAL2 b) {
    precise REAL lo = a.x * b.x;
    precise REAL member = min(a.y, IM_LARGEST) * b.x;
    precise REAL hi = a.y * b.y;
    hi = IM_SELECT(hi > member, hi, member);
    return im_not_negative(im_outwards(REAL2(lo, hi)));
}

// A number times an interval.
REAL2 im_scale(REAL s, REAL2 a) {
    precise REAL2 r = s * a;
    precise REAL member = s * max(a.x, -IM_LARGEST);
    precise REAL lo = IM_SELECT(r.x < member, r.x, member);
    lo = IM_SELECT(r.y < lo, r.y, lo);
    precise REAL hi = IM_SELECT(r.x > member, r.x, member);
    hi = IM_SELECT(r.y > hi, r.y, hi);
    return im_outwards(REAL2(lo, hi));
}

// s is a positive constant.
REAL2 im_scale_up(REAL s, REAL2 a) {
    precise REAL2 r = s * a;
    return im_outwards(r);
}

// a * a for the same member a, tighter than im_multiply(a, a) for two independent members.
REAL2 im_square(REAL2 a) {
    precise REAL2 size = im_abs(a);
    precise REAL2 r = size * size;
    return im_not_negative(im_outwards(r));
}

// Returns r, or exactly 0 if a is 0. r is a product with the factor a, or a sum of two intervals
// with the hull a: 0 times an unbounded factor is 0. Tests a, since r may be 0 by underflow.
REAL2 im_unless_zero(REAL2 a, REAL2 r) {
    return IM_SELECT2(a.x == 0.0 && a.y == 0.0, REAL2(0.0), r);
}

REAL2 im_hull(REAL2 a, REAL2 b) {
    return REAL2(min(a.x, b.x), max(a.y, b.y));
}

REAL2 im_select(REAL2 a, REAL2 b, REAL2 then, REAL2 otherwise) {
    REAL2 either = im_hull(then, otherwise);
    either = IM_SELECT2(a.x >= b.y, otherwise, either);
    return IM_SELECT2(a.y < b.x, then, either);
}
