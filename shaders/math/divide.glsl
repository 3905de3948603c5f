// im_divide. Needs bits.glsl.
//
// Within +-IM_SATURATION. a/0 has the sign of a whatever the sign of the zero; 0/0 is NaN.

float im_divide(float a, float b) {
    precise float q = a / b;
    q = q > IM_SATURATION ? IM_SATURATION : q;
    q = q < -IM_SATURATION ? -IM_SATURATION : q;
    float by_zero = a > 0.0 ? IM_SATURATION : (a < 0.0 ? -IM_SATURATION : IM_NAN);
    q = b == 0.0 ? by_zero : q;
    return q;
}
