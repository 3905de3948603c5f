// im_erf on intervals. Needs arithmetic.glsl, math/erf.glsl.
//
// The kernel's tests allow 2.3 ulps; 2^-20 of the result is counted, which is 8 ulps.
vec2 im_erf(vec2 a) {
    vec2 r = im_widen(vec2(im_erf(a.x), im_erf(a.y)), 9.53674316e-7);
    r = clamp(r, -1.0, 1.0);
    return IM_SELECT2(a.x >= 0.0, im_not_negative(r), r);
}
