// im_asinh, im_acosh on intervals. Needs arithmetic.glsl, math/inverse_hyperbolic.glsl.
//
// The kernels' tests allow 4.4 ulps; 2^-20 of the result is counted, which is 8 ulps.
vec2 im_asinh(vec2 a) {
    vec2 inner = clamp(a, -IM_LARGEST, IM_LARGEST);
    vec2 r = im_widen(vec2(im_asinh(inner.x), im_asinh(inner.y)), 9.53674316e-7);
    r.x = IM_SELECT(a.x < -IM_LARGEST, -IM_INFINITY, r.x);
    r.y = IM_SELECT(a.y > IM_LARGEST, IM_INFINITY, r.y);
    return IM_SELECT2(a.x >= 0.0, im_not_negative(r), r);
}

vec2 im_acosh(vec2 a) {
    vec2 inner = min(a, vec2(IM_LARGEST));
    vec2 r = im_widen(vec2(im_acosh(inner.x), im_acosh(inner.y)), 9.53674316e-7);
    r.y = IM_SELECT(a.y > IM_LARGEST, IM_INFINITY, r.y);
    return im_not_negative(r);
}
