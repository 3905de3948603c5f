// im_exp, im_sinh, im_cosh, im_tanh on intervals of doubles. Needs floats_around.glsl,
// interval/exp.glsl of floats.
dvec2 im_exp(dvec2 a) { return dvec2(im_exp(im_floats_around(a))); }
dvec2 im_sinh(dvec2 a) { return dvec2(im_sinh(im_floats_around(a))); }
dvec2 im_cosh(dvec2 a) { return dvec2(im_cosh(im_floats_around(a))); }
dvec2 im_tanh(dvec2 a) { return dvec2(im_tanh(im_floats_around(a))); }
