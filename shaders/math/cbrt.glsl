// im_cbrt. Needs no other file.
//
// The root has the sign of x. Its largest error over all floats is 1.1 ulps. Subnormal numbers
// count as 0.

float im_cbrt(float x) {
    uint bits = floatBitsToUint(x) & 0x7fffffffu;
    // |x| = m * 2^3n with m in [1/2, 4).
    uint third = (bits >> 23) / 3u;
    precise float m = uintBitsToFloat(bits - ((3u * third - 126u) << 23));
    // A polynomial that is off by at most 0.0019 of the root, and a step of Halley's method.
    precise float r = -5.48734237e-3;
    r = r * m + 6.08534925e-2;
    r = r * m - 0.265969396;
    r = r * m + 0.713050723;
    r = r * m + 0.497884125;
    precise float cube = r * r * r;
    r = r - r * ((cube - m) / (2.0 * cube + m));
    precise float y = r * uintBitsToFloat((third + 85u) << 23);
    y = IM_SELECT(bits < 0x00800000u, 0.0, y);
    y = IM_SELECT(x < 0.0, -y, y);
    return IM_SELECT(bits >= 0x7f800000u, x, y); // infinity and NaN
}
