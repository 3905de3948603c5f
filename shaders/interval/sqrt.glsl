// im_sqrt on intervals. Needs arithmetic.glsl.
//
// GLSL lets a driver take the root by way of its inverse, 2 ulps off; 8 are counted.
REAL2 im_sqrt(REAL2 a) {
    precise REAL2 r = sqrt(max(a, REAL2(0.0)));
    return im_not_negative(im_widen(r, IM_DRIVER_ERROR));
}
