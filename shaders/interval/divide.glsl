// im_divide on intervals. Needs arithmetic.glsl.
//
// If the divisor's lower end is 0, the quotient is bounded where possible: 0 counts as a small
// positive divisor. Any other divisor that holds 0, and 0/0, gives the entire line. GLSL allows a
// float quotient an error of 2.5 ulps for divisors up to 2^126, and the result 0 beyond; 8 ulps are
// counted.
REAL2 im_divide(REAL2 a, REAL2 b) {
    bool negative = b.y < 0.0;
    REAL2 n = IM_SELECT2(negative, -a.yx, a);
    REAL2 d = IM_SELECT2(negative, -b.yx, b);
    REAL least = d.x;
    // If there is a bound, the divisor is not negative; abs() makes its zero positive, too.
    d = abs(REAL2(min(d.x, IM_MOST_DIVISOR), d.y));
    precise REAL2 q =
        REAL2(n.x / IM_SELECT(n.x < 0.0, d.x, d.y), n.y / IM_SELECT(n.y < 0.0, d.y, d.x));
    q = im_saturate(im_widen(q, IM_DRIVER_ERROR));
    q.x = IM_SELECT(n.x >= 0.0, max(q.x, 0.0), q.x);
    q.y = IM_SELECT(n.y <= 0.0, min(q.y, 0.0), q.y);
    // Positive if there is a bound: the divisor is positive, or its lower end is 0 and the
    // numerator doesn't hold 0.
    REAL bounded = IM_SELECT(least == 0.0, max(n.x, -n.y), least);
    precise REAL2 result = IM_SELECT2(bounded > 0.0, q, IM_ENTIRE);
    return result;
}
