// im_sin, im_cos, im_sin_cos, im_tan. Needs bits.glsl, divide.glsl.
//
// Accurate up to |x| = 1e5. Beyond, the result is that of an argument within two spacings of
// floats; from 1e7 on it is merely a number in [-1, 1]. Infinity gives NaN.

// x = quadrant * pi/2 + the result, which is within +-pi/4, or slightly beyond for large x.
float im_quarter_turns(float x, out int quadrant) {
    float k = floor(x * 0.636619772 + 0.5);
    // pi/2 in parts of 8 bits: k times a part is exact up to 2^16, and the subtractions cancel.
    precise float r = x - k * 1.5703125;
    r = r - k * 4.84466552734375e-4;
    r = r + k * 6.407499313354492e-7;
    r = r - k * 9.92093629470503e-10;
    quadrant = int(k);
    // Where no digits of x are left, the clamp at least keeps the polynomials within +-1. It loses
    // NaN, so infinity and NaN are recognised by their bits.
    r = clamp(r, -1.5, 1.5);
    return IM_SELECT((floatBitsToUint(x) & 0x7f800000u) == 0x7f800000u, IM_NAN, r);
}

float im_sin_reduced(float r) {
    precise float z = r * r;
    precise float p = -1.9515295891e-4;
    p = p * z + 8.3321608736e-3;
    p = p * z - 1.6666654611e-1;
    precise float y = r + r * z * p;
    return y;
}

float im_cos_reduced(float r) {
    precise float z = r * r;
    precise float p = 2.443315711809948e-5;
    p = p * z - 1.388731625493765e-3;
    p = p * z + 4.166664568298827e-2;
    precise float y = 1.0 - (0.5 * z - z * z * p);
    return y;
}

// Sine and cosine together: a value and its slope need both, and one alone needs both polynomials.
vec2 im_sin_cos(float x) {
    int quadrant;
    float r = im_quarter_turns(x, quadrant);
    float s = im_sin_reduced(r);
    float c = im_cos_reduced(r);
    bool turned = (quadrant & 1) != 0;
    float sine = IM_SELECT(turned, c, s);
    float cosine = IM_SELECT(turned, s, c);
    return vec2(IM_SELECT((quadrant & 2) == 0, sine, -sine),
                IM_SELECT(((quadrant + 1) & 2) == 0, cosine, -cosine));
}

float im_sin(float x) {
    return im_sin_cos(x).x;
}

float im_cos(float x) {
    return im_sin_cos(x).y;
}

float im_tan(float x) {
    vec2 s = im_sin_cos(x);
    return im_divide(s.x, s.y);
}
