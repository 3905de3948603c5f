// im_exp, im_sinh, im_cosh, im_tanh on intervals. Needs arithmetic.glsl, math/exp.glsl.
//
// The kernels' tests allow up to 2.3 ulps; 2^-20 of the result is counted, which is 8 ulps.

#define IM_KERNEL_ERROR 9.53674316e-7

vec2 im_exp(vec2 a) {
    vec2 r = vec2(im_exp(a.x), im_exp(a.y));
    r.y = IM_SELECT(a.y > 69.0, IM_INFINITY, r.y); // saturated
    return im_not_negative(im_widen(r, IM_KERNEL_ERROR));
}

vec2 im_sinh(vec2 a) {
    vec2 r = vec2(im_sinh(a.x), im_sinh(a.y));
    r.x = IM_SELECT(a.x < -69.0, -IM_INFINITY, r.x);
    r.y = IM_SELECT(a.y > 69.0, IM_INFINITY, r.y);
    return im_widen(r, IM_KERNEL_ERROR);
}

vec2 im_cosh(vec2 a) {
    vec2 size = im_abs(a);
    vec2 r = vec2(im_cosh(size.x), im_cosh(size.y));
    r.y = IM_SELECT(size.y > 69.0, IM_INFINITY, r.y);
    r = im_widen(r, IM_KERNEL_ERROR);
    return vec2(max(r.x, 1.0), r.y);
}

vec2 im_tanh(vec2 a) {
    vec2 r = im_widen(vec2(im_tanh(a.x), im_tanh(a.y)), IM_KERNEL_ERROR);
    return clamp(r, -1.0, 1.0);
}
