// im_pow on intervals of doubles. Needs floats_around.glsl,
// interval/pow.glsl of floats.
dvec2 im_pow(dvec2 a, dvec2 b) { return dvec2(im_pow(im_floats_around(a), im_floats_around(b))); }

dvec2 im_pow(dvec2 a, double b) {
    bool is_float = double(float(b)) == b;
    vec2 base = im_floats_around(a);
    return dvec2(is_float ? im_pow(base, float(b)) : im_pow(base, im_floats_around(dvec2(b))));
}
