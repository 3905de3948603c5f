// Models of F at the points that float32 may make of one point of a ray: a value, its change with
// each coordinate by as much as rounding moves that, and the error of F beyond both. Needs
// interval/arithmetic.glsl.
#undef MODEL
#define MODEL PointModel
struct PointModel {
    REAL c;
    REAL3 aside;
    REAL error;
};

REAL md_sum(REAL3 a) {
    return abs(a.x) + abs(a.y) + abs(a.z);
}

REAL md_size(PointModel a) {
    return abs(a.c) + md_sum(a.aside);
}

PointModel md_of_PointModel(REAL value, REAL rounding) {
    return PointModel(value, REAL3(0.0), md_up(rounding * abs(value)));
}

PointModel md_negate(PointModel a) {
    return PointModel(-a.c, -a.aside, a.error);
}

PointModel md_add(PointModel a, PointModel b) {
    precise REAL c = a.c + b.c;
    precise REAL3 aside = a.aside + b.aside;
    return PointModel(c, aside, md_up(a.error + b.error + IM_ROUNDING * (abs(c) + md_sum(aside))));
}

PointModel md_shift(PointModel a, REAL by, REAL rounding) {
    precise REAL c = a.c + by;
    return PointModel(c, a.aside, md_up(a.error + rounding * abs(by) + IM_ROUNDING * abs(c)));
}

PointModel md_scale(REAL by, PointModel a, REAL rounding) {
    precise REAL c = by * a.c;
    precise REAL3 aside = by * a.aside;
    REAL off = a.error + (rounding + IM_ROUNDING) * (md_size(a) + a.error);
    return PointModel(c, aside, md_up(abs(by) * off));
}

// By a power of two.
PointModel md_scale_by_power(REAL by, PointModel a) {
    precise REAL c = by * a.c;
    precise REAL3 aside = by * a.aside;
    return PointModel(c, aside, md_up(abs(by) * a.error));
}

PointModel md_multiply(PointModel a, PointModel b) {
    precise REAL c = a.c * b.c;
    precise REAL3 aside = a.c * b.aside + b.c * a.aside;
    REAL aside_a = md_sum(a.aside), aside_b = md_sum(b.aside);
    REAL size_a = abs(a.c) + aside_a, size_b = abs(b.c) + aside_b;
    REAL off = a.error * (size_b + b.error) + size_a * b.error + aside_a * aside_b +
               2.0 * IM_ROUNDING * size_a * size_b;
    return PointModel(c, aside, md_up(off));
}

PointModel md_square(PointModel a) {
    precise REAL c = a.c * a.c;
    precise REAL3 aside = 2.0 * a.c * a.aside;
    REAL sum = md_sum(a.aside), size = abs(a.c) + sum;
    REAL off = a.error * (2.0 * size + a.error) + sum * sum + 2.0 * IM_ROUNDING * size * size;
    return PointModel(c, aside, md_up(off));
}

REAL2 md_range(PointModel a) {
    REAL off = md_up(md_sum(a.aside) + a.error + IM_ROUNDING * abs(a.c));
    return REAL2(a.c - off, a.c + off);
}

PointModel md_without_bound(PointModel a) {
    return PointModel(a.c, a.aside, IM_INFINITY);
}
