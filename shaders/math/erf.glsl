// im_erf. Needs bits.glsl, exp.glsl.
//
// Polynomials of least largest error, by Remez's algorithm: erf(x)/x to 1.3e-9, and beyond 1 the
// logarithm of 1 - erf(x), which leaves errors of 1.1e-9 of erf(x). Its largest error over all
// floats is 1.7 ulps.

float im_erf(float x) {
    float a = abs(x);
    precise float z = x * x;
    precise float p = 7.85386219e-5;
    p = p * z - 8.01019371e-4;
    p = p * z + 5.18832775e-3;
    p = p * z - 2.68538129e-2;
    p = p * z + 0.112835854;
    p = p * z - 0.37612626;
    p = p * z + 0.128379166;
    precise float near = x * (1.0 + p); // x p may be flushed to 0 where x is not
    // From 4 on it is 1 in floats.
    float b = min(a, 4.0);
    precise float q = 1.86378122e-4;
    q = q * b - 2.94764759e-3;
    q = q * b + 2.18380205e-2;
    q = q * b - 0.103106663;
    q = q * b - 0.63814497;
    q = q * b - 1.12708914;
    q = q * b - 3.4153997e-4;
    precise float far = 1.0 - im_exp(q);
    far = IM_SELECT(x < 0.0, -far, far);
    precise float y = IM_SELECT(a < 1.0, near, far);
    return IM_SELECT(im_is_nan(x), x, y);
}
