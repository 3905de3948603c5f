// im_add, im_subtract, im_multiply, im_square, im_abs, im_select on intervals. Needs bits.glsl.
//
// An interval (lo, hi) is as in src/formula/interval.h: lo <= hi, lo < infinity, hi > -infinity, no
// NaN, an infinite end is no bound, and 0 times an unbounded interval is 0. Ends are 0 or normal:
// drivers may flush others to 0.
//
// Rounding outwards: a sum or product r is the nearest float to the exact value, which is off by at
// most 2^-24 |r|. 3/2 of that reaches a float at or beyond the exact value, see interval.h. Where
// |r| < 2^-102 that product underflows and results may have been flushed, but errors are at most
// 2^-126, and IM_STEP = 2^-124 is more than that and the flush of its own difference.

#define IM_INFINITY uintBitsToFloat(0x7f800000u)
#define IM_ENTIRE vec2(-IM_INFINITY, IM_INFINITY)
#define IM_STEP 4.70197740e-38

// The bounds of values that came out as r, each off by at most `relative` |r| or IM_STEP. A bound
// that overflowed inwards is the largest float.
vec2 im_widen(vec2 r, float relative) {
    precise vec2 inner = vec2(min(r.x, IM_LARGEST), max(r.y, -IM_LARGEST));
    precise vec2 margin = abs(inner) * relative + IM_STEP;
    precise vec2 outer = vec2(inner.x - margin.x, inner.y + margin.y);
    return outer;
}

vec2 im_outwards(vec2 r) {
    return im_widen(r, 8.94069672e-8); // 1.5 * 2^-24
}

// Of what is never negative on paper.
vec2 im_not_negative(vec2 a) {
    return vec2(max(a.x, 0.0), a.y);
}

// Results beyond the saturation of floats are unbounded, and begin no further out than there.
vec2 im_saturate(vec2 a) {
    return vec2(min(a.x, IM_SATURATION), max(a.y, -IM_SATURATION));
}

// The smallest and the largest distance from 0.
vec2 im_abs(vec2 a) {
    return vec2(max(max(a.x, -a.y), 0.0), max(-a.x, a.y));
}

vec2 im_add(vec2 a, vec2 b) {
    precise vec2 r = a + b;
    return im_outwards(r);
}

vec2 im_subtract(vec2 a, vec2 b) {
    precise vec2 r = a - b.yx;
    return im_outwards(r);
}

// 0 times an infinite end is NaN here and 0 by meaning. The comparisons below, precise so that none
// becomes a min(), drop NaN; a product of two finite members takes its place.
vec2 im_multiply(vec2 a, vec2 b) {
    precise float p = a.x * b.x;
    precise float q = a.x * b.y;
    precise float r = a.y * b.x;
    precise float s = a.y * b.y;
    precise float member = max(a.x, -IM_LARGEST) * max(b.x, -IM_LARGEST);
    precise float lo = p < member ? p : member;
    lo = q < lo ? q : lo;
    lo = r < lo ? r : lo;
    lo = s < lo ? s : lo;
    precise float hi = p > member ? p : member;
    hi = q > hi ? q : hi;
    hi = r > hi ? r : hi;
    hi = s > hi ? s : hi;
    return im_outwards(vec2(lo, hi));
}

// b >= 0, so that it is the ends of a alone that are the outermost.
vec2 im_multiply_by_not_negative(vec2 a, vec2 b) {
    precise vec2 inner = vec2(max(a.x, -IM_LARGEST), min(a.y, IM_LARGEST)) * b.x;
    precise vec2 outer = a * b.y;
    precise float lo = outer.x < inner.x ? outer.x : inner.x;
    precise float hi = outer.y > inner.y ? outer.y : inner.y;
    return im_outwards(vec2(lo, hi));
}

vec2 im_multiply_not_negative(vec2 a, vec2 b) {
    precise float lo = a.x * b.x;
    precise float member = min(a.y, IM_LARGEST) * b.x;
    precise float hi = a.y * b.y;
    hi = hi > member ? hi : member;
    return im_not_negative(im_outwards(vec2(lo, hi)));
}

// A number times an interval.
vec2 im_scale(float s, vec2 a) {
    precise vec2 r = s * a;
    precise float member = s * max(a.x, -IM_LARGEST);
    precise float lo = r.x < member ? r.x : member;
    lo = r.y < lo ? r.y : lo;
    precise float hi = r.x > member ? r.x : member;
    hi = r.y > hi ? r.y : hi;
    return im_outwards(vec2(lo, hi));
}

// s is a positive constant.
vec2 im_scale_up(float s, vec2 a) {
    precise vec2 r = s * a;
    return im_outwards(r);
}

// a * a for one a, which a * b for two that happen to be equal is not.
vec2 im_square(vec2 a) {
    precise vec2 size = im_abs(a);
    precise vec2 r = size * size;
    return im_not_negative(im_outwards(r));
}

vec2 im_select(vec2 a, vec2 b, vec2 then, vec2 otherwise) {
    vec2 either = vec2(min(then.x, otherwise.x), max(then.y, otherwise.y));
    either = a.x >= b.y ? otherwise : either;
    return a.y < b.x ? then : either;
}
