// im_exact_sum, im_exact_product, im_exact_quotient: results of arithmetic where that is exact.
// Needs arithmetic.glsl.
//
// floor and sign jump at single numbers. An argument that is such a number over some region, as
// floor(x)/2 and x*max(0, y) are, would seem to jump all over the region if it were rounded
// outwards. So where both operands are numbers, and the result is exact, it is a number. Rounding
// errors are computed without rounding (Knuth's sum, Dekker's product). They are told from 0 where
// drivers flush subnormal numbers, as the results are at least 2^-60 and operands are 0 or normal.

#define IM_TOLD 8.67361738e-19 // 2^-60
#define IM_SPLIT 1.0e15        // numbers up to this are split without overflow

bool im_is_number(REAL2 a) {
    return a.x == a.y;
}

bool im_is_zero(REAL2 a) {
    return a.x == 0.0 && a.y == 0.0;
}

// a + b, or `r` where that is not exact.
REAL2 im_exact_sum(REAL2 a, REAL2 b, REAL2 r) {
    precise REAL sum = a.x + b.x;
    precise REAL b_in_sum = sum - a.x;
    precise REAL a_in_sum = sum - b_in_sum;
    precise REAL error = (a.x - a_in_sum) + (b.x - b_in_sum);
    bool is_told = abs(sum) >= IM_TOLD && abs(sum) <= IM_LARGEST && error == 0.0;
    bool is_exact = im_is_number(a) && im_is_number(b) && (a.x == -b.x || is_told);
    REAL2 exact = IM_SELECT2(is_exact, REAL2(sum), r);
    exact = IM_SELECT2(im_is_zero(a), b, exact);
    return IM_SELECT2(im_is_zero(b), a, exact);
}

// Whether p, which is a * b rounded to the nearest number, is just that.
bool im_is_product(REAL a, REAL b, REAL p) {
    precise REAL a_part = a * IM_SPLITTER;
    precise REAL a_rest = a_part - a;
    precise REAL a_high = a_part - a_rest;
    precise REAL a_low = a - a_high;
    precise REAL b_part = b * IM_SPLITTER;
    precise REAL b_rest = b_part - b;
    precise REAL b_high = b_part - b_rest;
    precise REAL b_low = b - b_high;
    precise REAL high = a_high * b_high - p;
    precise REAL middle = (high + a_high * b_low) + a_low * b_high;
    precise REAL error = middle + a_low * b_low;
    bool is_split = max(abs(a), abs(b)) <= IM_SPLIT;
    return is_split && abs(p) >= IM_TOLD && error == 0.0;
}

// a * b, or `r` where that is not exact. 0 times anything is 0.
REAL2 im_exact_product(REAL2 a, REAL2 b, REAL2 r) {
    precise REAL product = a.x * b.x;
    bool is_exact = im_is_number(a) && im_is_number(b) && im_is_product(a.x, b.x, product);
    REAL2 exact = IM_SELECT2(is_exact, REAL2(product), r);
    return IM_SELECT2(im_is_zero(a) || im_is_zero(b), REAL2(0.0), exact);
}

// a / b where that is a whole number, else `r`.
REAL2 im_exact_quotient(REAL2 a, REAL2 b, REAL2 r) {
    precise REAL quotient = floor(a.x / b.x + 0.5);
    precise REAL product = quotient * b.x;
    bool are_numbers = im_is_number(a) && im_is_number(b) && product == a.x;
    bool is_exact = are_numbers && im_is_product(quotient, b.x, product);
    REAL2 exact = IM_SELECT2(is_exact, REAL2(quotient), r);
    return IM_SELECT2(im_is_zero(a) && (b.x > 0.0 || b.y < 0.0), REAL2(0.0), exact);
}
