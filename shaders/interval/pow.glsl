// im_pow on intervals. Needs arithmetic.glsl, math/pow.glsl.
//
// The kernel's tests allow up to 5 ulps; 2^-19 of the result is counted, which is 16 ulps. Powers
// are monotone in base and in exponent, so their extremes are at the ends of both.

#define IM_POWER_ERROR 1.90734863e-6

// Powers of a base that isn't negative, from the kernel's results at both ends.
vec2 im_powers(float least, float most) {
    return im_saturate(im_not_negative(im_widen(vec2(least, most), IM_POWER_ERROR)));
}

// A negative base has powers only for integer exponents.
vec2 im_pow(vec2 a, float b) {
    precise vec2 r = vec2(im_pow(abs(a.x), b), im_pow(abs(a.y), b));
    vec2 size = im_powers(min(r.x, r.y), max(r.x, r.y));
    bool below = a.x < 0.0;
    bool across = below && a.y >= 0.0;
    bool whole = floor(b) == b;
    bool odd = floor(0.5 * b) != 0.5 * b;
    // 0 lies inside the base.
    vec2 even_across = IM_SELECT2(b > 0.0, vec2(0.0, size.y), vec2(size.x, IM_INFINITY));
    vec2 even_power = IM_SELECT2(across, even_across, size);
    vec2 left = im_powers(r.x, r.x);
    vec2 right = im_powers(r.y, r.y);
    vec2 odd_across = IM_SELECT2(b > 0.0, vec2(-left.y, right.y), IM_ENTIRE);
    vec2 odd_power = IM_SELECT2(across, odd_across, -size.yx);
    vec2 signed_power = IM_SELECT2(whole, IM_SELECT2(odd, odd_power, even_power), IM_ENTIRE);
    vec2 power = IM_SELECT2(below, signed_power, size);
    return IM_SELECT2(b == 0.0, vec2(1.0), power);
}

vec2 im_pow(vec2 a, vec2 b) {
    vec2 size = im_not_negative(a);
    precise vec2 p = vec2(im_pow(size.x, b.x), im_pow(size.x, b.y));
    precise vec2 q = vec2(im_pow(size.y, b.x), im_pow(size.y, b.y));
    vec2 least = min(p, q);
    vec2 most = max(p, q);
    vec2 power = im_powers(min(least.x, least.y), max(most.x, most.y));
    return IM_SELECT2(a.x < 0.0, IM_ENTIRE, power);
}
