// im_erf on intervals of doubles. Needs floats_around.glsl,
// interval/erf.glsl of floats.
dvec2 im_erf(dvec2 a) { return dvec2(im_erf(im_floats_around(a))); }
