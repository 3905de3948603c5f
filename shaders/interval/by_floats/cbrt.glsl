// im_cbrt on intervals of doubles. Needs floats_around.glsl,
// interval/cbrt.glsl of floats.
dvec2 im_cbrt(dvec2 a) { return dvec2(im_cbrt(im_floats_around(a))); }
