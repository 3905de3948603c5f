// Operations of all kinds of models; MODEL is the kind. Needs a file of shaders/models/ that defines
// it.

MODEL md_subtract(MODEL a, MODEL b) {
    return md_add(a, md_negate(b));
}

// Divides by a number, not a model. There is no bound where evaluation would saturate.
MODEL md_divide(MODEL a, REAL by, REAL rounding) {
    REAL size = abs(by);
    MODEL r = md_scale(REAL(1.0) / by, a, 1.000001 * rounding + 2.0 * IM_DRIVER_ERROR);
    REAL2 range = abs(md_range(r));
    bool holds = size > 1.0e-30 && size < 1.0e30 && max(range.x, range.y) < IM_SATURATION;
    if (!holds) r = md_without_bound(r);
    return r;
}

// One of both, if it is certain which: so a polynomial stays one over the piece.
MODEL md_min(MODEL a, MODEL b) {
    REAL2 of_a = md_range(a), of_b = md_range(b);
    MODEL either = md_without_bound(a);
    if (of_a.y < of_b.x) either = a;
    if (of_b.y < of_a.x) either = b;
    return either;
}

MODEL md_max(MODEL a, MODEL b) {
    return md_negate(md_min(md_negate(a), md_negate(b)));
}

// a, if it is certainly below its cut-off `end`; beyond that, F is another function on paper.
MODEL md_below(MODEL a, MODEL end) {
    if (!(md_range(a).y < md_range(end).x)) a = md_without_bound(a);
    return a;
}

MODEL md_above(MODEL a, MODEL end) {
    return md_negate(md_below(md_negate(a), md_negate(end)));
}
