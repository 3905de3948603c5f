// im_log. Needs bits.glsl.
//
// log(0) is -IM_SATURATION, log of a negative number is NaN, log(infinity) is IM_SATURATION.

// x = 2^n * (1 + f) with 1 + f in [2/3, 4/3), for normal x > 0; returns f. Around 1, n = 0 and
// f = x - 1 exactly, which keeps the relative accuracy there.
float im_log_reduce(float x, out float n) {
    int bits = floatBitsToInt(x);
    int exponent = (bits - 0x3f2aaaab) >> 23;
    n = float(exponent);
    return intBitsToFloat(bits - (exponent << 23)) - 1.0;
}

float im_log(float x) {
    float n;
    precise float f = im_log_reduce(x, n);
    precise float p = -0.12891680;
    p = p * f + 0.139844358;
    p = p * f - 0.121842623;
    p = p * f + 0.140058696;
    p = p * f - 0.166804880;
    p = p * f + 0.200104058;
    p = p * f - 0.249997973;
    p = p * f + 0.333332151;
    precise float y = n * 0.693359375 + (f + (f * f * (f * p - 0.5) - n * 2.12194440e-4));
    y = IM_SELECT(x > IM_LARGEST, IM_SATURATION, y);
    y = IM_SELECT(x >= IM_SMALLEST, y, IM_SELECT(x >= 0.0, -IM_SATURATION, IM_NAN));
    return y;
}
