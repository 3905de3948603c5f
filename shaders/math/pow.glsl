// im_pow, im_pow_and_lower. Needs bits.glsl, exp.glsl, log.glsl.
//
// For a > 0 accurate to a few ulp, however large b*log(a) is. The logarithm and its product with b
// are carried in two floats, since b multiplies an error of the logarithm. pow(a, 0) = 1 even for
// a = 0 or NaN. pow(0, b) is 0 for b > 0 and IM_SATURATION for b < 0. For a < 0 an integer b gives
// the signed power, any other b NaN. Results are within +-IM_SATURATION.

// log(a) = high + low for normal a > 0. high has 12 bits, so that its products are exact.
float im_log_split(float a, precise out float low) {
    float n;
    precise float f = im_log_reduce(a, n);
    // s = f/(2 + f) = s_high + s_low; log(1 + f) = 2s + 2s^3/3 + 2s^5/5 + ...
    precise float g = 2.0 + f;
    precise float g_high = im_leading(g);
    precise float g_low = f - (g_high - 2.0);
    precise float s = f / g;
    precise float s_high = im_leading(s);
    precise float s_low = ((f - s_high * g_high) - s_high * g_low) / g;
    precise float z = s * s;
    precise float p = 0.241034806;
    p = p * z + 0.285067946;
    p = p * z + 0.400008678;
    p = p * z + 0.666666627;
    precise float tail = 2.0 * s_low + s * z * p;

    precise float whole = n * 0.693359375;
    precise float sum = whole + 2.0 * s_high;
    precise float rest = (2.0 * s_high - (sum - whole)) + (tail - n * 2.12194440e-4);
    precise float high = im_leading(sum + rest);
    low = rest - (high - sum);
    return high;
}

// a^b from the logarithm of a > 0, without the special cases.
float im_pow_of_log(float l_high, float l_low, float b) {
    // An infinite b would split into infinity - infinity; so large a finite b gives the same.
    b = clamp(b, -IM_SATURATION, IM_SATURATION);
    precise float b_high = im_leading(b);
    precise float b_low = b - b_high;
    precise float y_high = b_high * l_high;
    precise float y_low = b_low * l_high + b * l_low;
    precise float y = y_high + y_low;
    float k = floor(y * 1.44269504 + 0.5);
    precise float r = ((y_high - k * 0.693359375) + k * 2.12194440e-4) + y_low;
    precise float power = im_exp_reduced(r, int(k));
    power = IM_SELECT(y >= 69.07755, IM_SATURATION, power);
    return IM_SELECT(y < -87.33654, 0.0, power);
}

// a^b from |a|^b.
float im_pow_special(float a, float b, float y) {
    float size = abs(a);
    y = IM_SELECT(size < IM_SMALLEST, IM_SELECT(b > 0.0, 0.0, IM_SATURATION), y);
    y = IM_SELECT(size > IM_LARGEST, IM_SELECT(b > 0.0, IM_SATURATION, 0.0), y);
    bool odd = floor(0.5 * b) != 0.5 * b;
    float signed_power = IM_SELECT(floor(b) != b, IM_NAN, IM_SELECT(odd, -y, y));
    y = IM_SELECT(a < 0.0, signed_power, y);
    y = IM_SELECT(im_is_nan(a), IM_NAN, y);
    y = IM_SELECT(im_is_nan(b), IM_NAN, y);
    return IM_SELECT(b == 0.0, 1.0, y);
}

float im_pow(float a, float b) {
    precise float low;
    precise float high = im_log_split(abs(a), low);
    return im_pow_special(a, b, im_pow_of_log(high, low, b));
}

// a^b and a^(b-1), a value and its slope, from one logarithm.
vec2 im_pow_and_lower(float a, float b) {
    precise float low;
    precise float high = im_log_split(abs(a), low);
    return vec2(im_pow_special(a, b, im_pow_of_log(high, low, b)),
                im_pow_special(a, b - 1.0, im_pow_of_log(high, low, b - 1.0)));
}
