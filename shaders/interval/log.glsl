// im_log on intervals. Needs arithmetic.glsl, math/log.glsl.
//
// The kernel's tests allow 1.25 ulps; 2^-20 of the result is counted, which is 8 ulps.
vec2 im_log(vec2 a) {
    vec2 inner = clamp(a, IM_SMALLEST, IM_LARGEST);
    vec2 r = im_widen(vec2(im_log(inner.x), im_log(inner.y)), 9.53674316e-7);
    r.x = IM_SELECT(a.x < IM_SMALLEST, -IM_INFINITY, r.x);
    r.y = IM_SELECT(a.y > IM_LARGEST, IM_INFINITY, r.y);
    return IM_SELECT2(a.x < 0.0, IM_ENTIRE, r);
}
