// im_sqrt. Needs bits.glsl.
//
// A slightly negative argument comes from rounding, so all negative ones count as 0. NaN stays NaN;
// max() loses it, and so does a selection of 0 for a < 0 in Mesa, which turns the comparison round.

float im_sqrt(float a) {
    return IM_SELECT(im_is_nan(a), a, sqrt(max(a, 0.0)));
}
