// im_chebyshev, im_chebyshev_stopped, im_chebyshev_slope, im_chebyshev_steep on doubles. Needs
// floats_around.glsl, interval/chebyshev.glsl of floats.
dvec2 im_chebyshev(int n, dvec2 a) { return dvec2(im_chebyshev(n, im_floats_around(a))); }
dvec2 im_chebyshev_stopped(int n, float reach, float stop, dvec2 a) {
    return dvec2(im_chebyshev_stopped(n, reach, stop, im_floats_around(a)));
}
dvec2 im_chebyshev_slope(int n, dvec2 a) { return dvec2(im_chebyshev_slope(n, im_floats_around(a))); }

dvec2 im_chebyshev_steep(float bound, dvec2 a) {
    return dvec2(im_chebyshev_steep(bound, im_floats_around(a)));
}
