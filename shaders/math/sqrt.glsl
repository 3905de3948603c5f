// im_sqrt. Needs bits.glsl.
//
// Slightly negative arguments come from rounding, so all negative ones count as 0. NaN stays NaN.
// max() loses it, and so does a selection of 0 for a < 0, whose comparison Mesa reverses.

float im_sqrt(float a) {
    return IM_SELECT(im_is_nan(a), a, sqrt(max(a, 0.0)));
}
