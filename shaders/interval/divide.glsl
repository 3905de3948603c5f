// im_divide on intervals. Needs arithmetic.glsl.
//
// Divisors down to 0 from above are divided by as far as possible, 0 itself giving what positive
// divisors near it give. Other divisors that hold 0, and 0/0, give the entire line. GLSL allows a
// quotient 2.5 ulps of error while the divisor is at most 2^126, and 0 beyond: 2^-21 are counted.
vec2 im_divide(vec2 a, vec2 b) {
    bool negative = b.y < 0.0;
    vec2 n = negative ? -a.yx : a;
    vec2 d = negative ? -b.yx : b;
    float least = d.x;
    // What divides is not negative where there is a bound; nor is its zero.
    d = abs(vec2(min(d.x, 4.25352959e37), d.y));
    precise vec2 q = vec2(n.x / (n.x < 0.0 ? d.x : d.y), n.y / (n.y < 0.0 ? d.y : d.x));
    q = im_saturate(im_widen(q, 4.76837158e-7));
    q.x = n.x >= 0.0 ? max(q.x, 0.0) : q.x;
    q.y = n.y <= 0.0 ? min(q.y, 0.0) : q.y;
    // Positive if there is a bound: the divisor is, or it ends at 0 and the numerator doesn't hold
    // 0.
    float bounded = least == 0.0 ? max(n.x, -n.y) : least;
    precise vec2 result = bounded > 0.0 ? q : IM_ENTIRE;
    return result;
}
