// im_asinh, im_acosh on intervals of doubles. Needs floats_around.glsl,
// interval/inverse_hyperbolic.glsl of floats.
dvec2 im_asinh(dvec2 a) { return dvec2(im_asinh(im_floats_around(a))); }
dvec2 im_acosh(dvec2 a) { return dvec2(im_acosh(im_floats_around(a))); }
