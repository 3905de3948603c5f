// im_asin, im_acos, im_atan on intervals. Needs arithmetic.glsl, math/inverse_trig.glsl.
//
// The kernels' tests allow 1.7 ulps for asin and 2.6 for atan; 2^-20 of the result is counted,
// which is 8 ulps. acos: 2e-7, and 1.7 ulps of small results; 4e-7 and 2^-20 are counted.

vec2 im_asin(vec2 a) {
    return im_widen(vec2(im_asin(a.x), im_asin(a.y)), 9.53674316e-7);
}

vec2 im_acos(vec2 a) {
    precise vec2 r = vec2(im_acos(a.y), im_acos(a.x));
    precise vec2 margin = min(r * 9.53674316e-7, vec2(4.0e-7));
    precise vec2 outer = vec2(r.x - margin.x, r.y + margin.y);
    return outer;
}

vec2 im_atan(vec2 a) {
    vec2 inner = clamp(a, -IM_LARGEST, IM_LARGEST);
    return im_widen(vec2(im_atan(inner.x), im_atan(inner.y)), 9.53674316e-7);
}
