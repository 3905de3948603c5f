// im_asin, im_acos, im_atan, im_atan2, im_angle on intervals of doubles. Needs floats_around.glsl,
// interval/inverse_trig.glsl of floats.
dvec2 im_asin(dvec2 a) { return dvec2(im_asin(im_floats_around(a))); }
dvec2 im_acos(dvec2 a) { return dvec2(im_acos(im_floats_around(a))); }
dvec2 im_atan(dvec2 a) { return dvec2(im_atan(im_floats_around(a))); }
dvec2 im_atan2(dvec2 a, dvec2 b) {
    return dvec2(im_atan2(im_floats_around(a), im_floats_around(b)));
}
dvec2 im_angle(dvec2 a, dvec2 b) {
    return dvec2(im_angle(im_floats_around(a), im_floats_around(b)));
}
