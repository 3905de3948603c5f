// im_exp, im_sinh, im_cosh, im_tanh. Needs no other file.
//
// exp and cosh saturate at IM_SATURATION and sinh at +-IM_SATURATION instead of overflowing, so
// that a term exp(100)*0 of a field is 0 and not NaN. exp is 0 below the smallest normal float. NaN
// gives NaN. For this, selections are written so that a comparison with NaN keeps it. They are
// precise, since Mesa otherwise makes min() and max() of them. They avoid 0.0 as the first operand,
// for which Mesa reverses the comparison even so.

// exp(r) * 2^exponent for |r| <= ln(2)/2; 0 where the power is below the normal floats.
float im_exp_reduced(float r, int exponent) {
    // Estrin's order, not Horner's: shorter chains, since each term of a sum may call this.
    precise float z = r * r;
    precise float p = (0.166665211 * r + 0.49999994) +
                      z * ((0.00836871658 * r + 0.041668389) + z * 0.00138145988);
    precise float e = 1.0 + (r + z * p);
    return e * intBitsToFloat(max(exponent + 127, 0) << 23);
}

// exp(x) * 2^shift for x >= -100. Meaningless above the range of floats, where the caller selects
// another value.
float im_exp_scaled(float x, int shift) {
    float k = floor(x * 1.44269504 + 0.5);
    // ln(2) in two parts; k times the first is exact.
    precise float r = (x - k * 0.693359375) + k * 2.12194440e-4;
    return im_exp_reduced(r, int(k) + shift);
}

float im_exp(float x) {
    precise float bounded = IM_SELECT(x < -100.0, -100.0, x);
    precise float y = im_exp_scaled(bounded, 0);
    y = IM_SELECT(x >= 69.07755, IM_SATURATION, y);
    return y;
}

float im_sinh(float x) {
    float a = abs(x);
    precise float z = x * x;
    precise float p = 2.81695137e-6;
    p = p * z + 1.98361595e-4;
    p = p * z + 0.0083333496;
    p = p * z + 0.166666672;
    precise float near = x + x * z * p;
    // Takes half of exp at once, since exp alone would saturate a factor of two too early.
    precise float h = im_exp_scaled(a, -1);
    precise float far = h - 0.25 / h;
    far = IM_SELECT(a > 69.7707, IM_SATURATION, far);
    far = IM_SELECT(x < 0.0, -far, far);
    precise float y = IM_SELECT(a < 1.0, near, far);
    return y;
}

float im_cosh(float x) {
    float a = abs(x);
    precise float h = im_exp_scaled(a, -1);
    precise float y = h + 0.25 / h;
    y = IM_SELECT(a > 69.7707, IM_SATURATION, y);
    return y;
}

float im_tanh(float x) {
    float a = abs(x);
    precise float z = x * x;
    precise float p = -0.00570498733;
    p = p * z + 0.0206390881;
    p = p * z - 0.0537397154;
    p = p * z + 0.133314416;
    p = p * z - 0.333332807;
    precise float near = x + x * z * p;
    precise float far = 1.0 - 2.0 / (im_exp(2.0 * a) + 1.0);
    far = IM_SELECT(x < 0.0, -far, far);
    precise float y = IM_SELECT(a < 0.625, near, far);
    return y;
}
