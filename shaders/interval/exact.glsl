// im_exact_sum, im_exact_product, im_exact_quotient: arithmetic with ends that are not rounded
// where they are exact. Needs arithmetic.glsl.
//
// floor and sign jump at single numbers. An argument that is such a number over some region, as
// floor(x)/2 and x*max(0, y) are, would seem to jump all over the region if it were rounded
// outwards, and so would one that has its end there at the region's border. Rounding errors are
// computed without rounding (Knuth's sum, Dekker's product). Drivers may flush subnormal numbers to
// 0, but an error that isn't 0 is a normal number where the result is at least 2^-60.

#define IM_TOLD 8.67361738e-19 // 2^-60
#define IM_SPLIT 1.0e15        // numbers up to this are split without overflow

bool im_is_number(REAL2 a) {
    return a.x == a.y;
}

bool im_is_zero(REAL2 a) {
    return a.x == 0.0 && a.y == 0.0;
}

// a + b, or `bound` where that is not exact.
REAL im_exact_sum_or(REAL a, REAL b, REAL bound) {
    precise REAL sum = a + b;
    precise REAL b_in_sum = sum - a;
    precise REAL a_in_sum = sum - b_in_sum;
    precise REAL error = (a - a_in_sum) + (b - b_in_sum);
    bool is_told = abs(sum) >= IM_TOLD && abs(sum) <= IM_LARGEST && error == 0.0;
    REAL exact = IM_SELECT(a == -b || is_told, sum, bound);
    exact = IM_SELECT(a == 0.0, b, exact);
    return IM_SELECT(b == 0.0, a, exact);
}

// `r`: the sum, rounded outwards.
REAL2 im_exact_sum(REAL2 a, REAL2 b, REAL2 r) {
    return REAL2(im_exact_sum_or(a.x, b.x, r.x), im_exact_sum_or(a.y, b.y, r.y));
}

// a * b, or `bound` where that is not exact.
REAL im_exact_product_or(REAL a, REAL b, REAL bound) {
    precise REAL product = a * b;
    precise REAL a_part = a * IM_SPLITTER;
    precise REAL a_rest = a_part - a;
    precise REAL a_high = a_part - a_rest;
    precise REAL a_low = a - a_high;
    precise REAL b_part = b * IM_SPLITTER;
    precise REAL b_rest = b_part - b;
    precise REAL b_high = b_part - b_rest;
    precise REAL b_low = b - b_high;
    precise REAL high = a_high * b_high - product;
    precise REAL middle = (high + a_high * b_low) + a_low * b_high;
    precise REAL error = middle + a_low * b_low;
    bool is_split = max(abs(a), abs(b)) <= IM_SPLIT;
    bool is_told = is_split && abs(product) >= IM_TOLD && error == 0.0;
    return IM_SELECT(is_told, product, bound);
}

// A product or quotient on its own side of 0.
REAL2 im_on_its_side(REAL2 a, REAL2 b, REAL2 r) {
    bool is_not_negative = min(a.x, b.x) >= 0.0 || max(a.y, b.y) <= 0.0;
    bool is_not_positive = max(a.y, -b.x) <= 0.0 || max(-a.x, b.y) <= 0.0;
    return REAL2(IM_SELECT(is_not_negative, max(r.x, 0.0), r.x),
                 IM_SELECT(is_not_positive, min(r.y, 0.0), r.y));
}

// `r`: the product, rounded outwards. 0 times anything is 0.
REAL2 im_exact_product(REAL2 a, REAL2 b, REAL2 r) {
    REAL2 of_sides = im_on_its_side(a, b, r);
    REAL factor = IM_SELECT(im_is_number(a), a.x, b.x);
    REAL2 ends = IM_SELECT2(im_is_number(a), b, a);
    ends = IM_SELECT2(factor < 0.0, ends.yx, ends);
    REAL2 exact = REAL2(im_exact_product_or(factor, ends.x, of_sides.x),
                        im_exact_product_or(factor, ends.y, of_sides.y));
    exact = IM_SELECT2(im_is_number(a) || im_is_number(b), exact, of_sides);
    return IM_SELECT2(im_is_zero(a) || im_is_zero(b), REAL2(0.0), exact);
}

// `r`: the quotient, rounded outwards. It is exact where it is a whole number.
REAL2 im_exact_quotient(REAL2 a, REAL2 b, REAL2 r) {
    precise REAL quotient = floor(a.x / b.x + 0.5);
    precise REAL product = quotient * b.x;
    bool are_numbers = im_is_number(a) && im_is_number(b) && product == a.x;
    bool is_exact = are_numbers && im_exact_product_or(quotient, b.x, IM_INFINITY) == a.x;
    bool is_by_0 = b.x <= 0.0 && b.y >= 0.0;
    REAL2 exact = IM_SELECT2(is_by_0, r, im_on_its_side(a, b, r));
    exact = IM_SELECT2(is_exact, REAL2(quotient), exact);
    return IM_SELECT2(im_is_zero(a) && !is_by_0, REAL2(0.0), exact);
}
