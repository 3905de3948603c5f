// im_asin, im_acos, im_atan on intervals of doubles. Needs floats_around.glsl,
// interval/inverse_trig.glsl of floats.
dvec2 im_asin(dvec2 a) { return dvec2(im_asin(im_floats_around(a))); }
dvec2 im_acos(dvec2 a) { return dvec2(im_acos(im_floats_around(a))); }
dvec2 im_atan(dvec2 a) { return dvec2(im_atan(im_floats_around(a))); }
