// im_log on intervals of doubles. Needs floats_around.glsl,
// interval/log.glsl of floats.
dvec2 im_log(dvec2 a) { return dvec2(im_log(im_floats_around(a))); }
