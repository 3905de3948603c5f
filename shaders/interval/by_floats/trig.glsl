// im_sin, im_cos, im_tan on intervals of doubles. Needs floats_around.glsl,
// interval/trig.glsl of floats.
dvec2 im_sin(dvec2 a) { return dvec2(im_sin(im_floats_around(a))); }
dvec2 im_cos(dvec2 a) { return dvec2(im_cos(im_floats_around(a))); }
dvec2 im_tan(dvec2 a) { return dvec2(im_tan(im_floats_around(a))); }
