// im_divide. Needs bits.glsl.
//
// Results are within +-IM_SATURATION. a/0 has the sign of a, for zeros of both signs; 0/0 is NaN.

float im_divide(float a, float b) {
    precise float q = a / b;
    q = IM_SELECT(q > IM_SATURATION, IM_SATURATION, q);
    q = IM_SELECT(q < -IM_SATURATION, -IM_SATURATION, q);
    float by_zero = IM_SELECT(a < 0.0, -IM_SATURATION, IM_NAN);
    by_zero = IM_SELECT(a > 0.0, IM_SATURATION, by_zero);
    q = IM_SELECT(b == 0.0, by_zero, q);
    return q;
}
