// im_sqrt on intervals. Needs arithmetic.glsl.
//
// GLSL lets a driver compute the root through its inverse, with an error of 2 ulps; 8 are counted.
REAL2 im_sqrt(REAL2 a) {
    precise REAL2 r = sqrt(max(a, REAL2(0.0)));
    return im_not_negative(im_widen(r, IM_DRIVER_ERROR));
}
