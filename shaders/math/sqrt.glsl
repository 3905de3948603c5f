// im_sqrt. Needs bits.glsl.
//
// A slightly negative argument comes from rounding, so all negative ones count as 0. NaN stays NaN;
// max() loses it, and so does `a < 0.0 ? 0.0 : sqrt(a)` in Mesa, which turns the comparison round.

float im_sqrt(float a) {
    return im_is_nan(a) ? a : sqrt(max(a, 0.0));
}
