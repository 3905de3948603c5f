// im_noise on intervals of doubles. Needs floats_around.glsl,
// interval/noise.glsl of floats.
dvec2 im_noise(dvec2 x, dvec2 y, dvec2 z, ivec3 order, double bound) {
    return dvec2(im_noise(im_floats_around(x), im_floats_around(y), im_floats_around(z), order,
                          float(bound)));
}
