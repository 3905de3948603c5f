// im_cbrt on intervals. Needs arithmetic.glsl, math/cbrt.glsl.
//
// The kernel's tests allow 1.6 ulps; 2^-20 of the result is counted, which is 8 ulps. Roots of
// subnormal numbers, which the kernel takes for 0, are less than 2.3e-13.
vec2 im_cbrt(vec2 a) {
    vec2 r = im_widen(vec2(im_cbrt(a.x), im_cbrt(a.y)), 9.53674316e-7);
    r.x = IM_SELECT(a.x < 0.0, min(r.x, -2.3e-13), r.x);
    r.y = IM_SELECT(a.y > 0.0, max(r.y, 2.3e-13), r.y);
    return IM_SELECT2(a.x >= 0.0, im_not_negative(r), r);
}
