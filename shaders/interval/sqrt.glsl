// im_sqrt on intervals. Needs arithmetic.glsl.
//
// GLSL lets a driver take the root by way of its inverse, 2 ulps off; 2^-21 are counted.
vec2 im_sqrt(vec2 a) {
    precise vec2 r = sqrt(max(a, vec2(0.0)));
    return im_not_negative(im_widen(r, 4.76837158e-7));
}
