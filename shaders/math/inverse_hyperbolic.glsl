// im_asinh, im_acosh. Needs bits.glsl, log.glsl.
//
// acosh is 0 below 1. Their largest errors over all floats are 2.1 and 2.9 ulps, also where they
// are small.

// log(1 + u) for u >= 0, without what the rounding of 1 + u loses.
float im_log_above_1(float u) {
    precise float sum = 1.0 + u;
    precise float lost = IM_SELECT(u < 1.0, u - (sum - 1.0), 1.0 - (sum - u));
    precise float y = im_log(sum) + lost / sum;
    return y;
}

// log(2 a), for an a whose square may be too large.
float im_log_of_twice(float a) {
    precise float y = im_log(a) + 0.693147182;
    return y;
}

float im_asinh(float x) {
    float a = abs(x);
    bool large = a > 1.0e9;
    float b = IM_SELECT(large, 1.0, a);
    precise float square = b * b;
    precise float u = b + square / (1.0 + sqrt(1.0 + square));
    precise float y = IM_SELECT(large, im_log_of_twice(a), im_log_above_1(u));
    y = IM_SELECT(x < 0.0, -y, y);
    return IM_SELECT(im_is_nan(x), x, y);
}

float im_acosh(float x) {
    bool large = x > 1.0e9;
    float a = IM_SELECT(large, 1.0, max(x, 1.0));
    precise float above = a - 1.0;
    precise float u = above + sqrt(above * (above + 2.0));
    precise float y = IM_SELECT(large, im_log_of_twice(x), im_log_above_1(u));
    return IM_SELECT(im_is_nan(x), x, y);
}
