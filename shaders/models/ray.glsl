// Models of F along all rays that float32 may make of one, over a piece: c.x + s c.y + s^2 c.z,
// with s from -1 at its beginning to 1 at its end. `aside` is the change with each of the points'
// coordinates, by as much as rounding moves it. `error` and `slope_error` bound how far F and its
// slope in s may be off. Needs interval/arithmetic.glsl and point.glsl.
//
// Coefficients of products, and those left out, are off by at most 4 times 2^-p of the product of
// both sums of sizes; those of sums by 2^-p of themselves. The points' coordinates are off by
// linear functions of s, whose slopes are at most their largest values. So the slope of what is
// left out is at most four times its size.
#undef MODEL
#define MODEL Model
struct Model {
    REAL3 c, aside;
    REAL error, slope_error;
};

// Bounds the change along the piece.
REAL md_change(Model a) {
    return abs(a.c.y) + abs(a.c.z);
}

REAL md_size(Model a) {
    return abs(a.c.x) + md_change(a) + md_sum(a.aside);
}

// The steepest slope in s.
REAL md_slope(Model a) {
    return md_change(a) + abs(a.c.z) + md_sum(a.aside);
}

// Bounds how far F may be from the quadratic.
REAL md_off(Model a) {
    return md_up(a.error + md_sum(a.aside));
}

// The same of its slope, where the slopes of the points' coordinates are `apart` times their
// sizes.
REAL md_slope_off(Model a, REAL apart) {
    return a.slope_error + apart * md_sum(a.aside);
}

Model md_coordinate(REAL c, REAL l, REAL3 aside, REAL off) {
    return Model(REAL3(c, l, 0.0), aside, off, off);
}

Model md_of_Model(REAL value, REAL rounding) {
    return Model(REAL3(value, 0.0, 0.0), REAL3(0.0), md_up(rounding * abs(value)), md_up(0.0));
}

Model md_negate(Model a) {
    return Model(-a.c, -a.aside, a.error, a.slope_error);
}

Model md_add(Model a, Model b) {
    precise REAL3 c = a.c + b.c;
    precise REAL3 aside = a.aside + b.aside;
    Model r = Model(c, aside, 0.0, 0.0);
    r.error = md_up(a.error + b.error + IM_ROUNDING * md_size(r));
    r.slope_error = md_up(a.slope_error + b.slope_error + IM_ROUNDING * md_slope(r));
    return r;
}

Model md_shift(Model a, REAL by, REAL rounding) {
    precise REAL c = a.c.x + by;
    REAL off = rounding * abs(by) + IM_ROUNDING * abs(c);
    return Model(REAL3(c, a.c.y, a.c.z), a.aside, md_up(a.error + off), a.slope_error);
}

Model md_scale(REAL by, Model a, REAL rounding) {
    precise REAL3 c = by * a.c;
    precise REAL3 aside = by * a.aside;
    REAL most = rounding + IM_ROUNDING;
    return Model(c, aside, md_up(abs(by) * (a.error + most * (md_size(a) + a.error))),
                 md_up(abs(by) * (a.slope_error + most * (md_slope(a) + a.slope_error))));
}

// By a power of two.
Model md_scale_by_power(REAL by, Model a) {
    precise REAL3 c = by * a.c;
    precise REAL3 aside = by * a.aside;
    return Model(c, aside, md_up(abs(by) * a.error), md_up(abs(by) * a.slope_error));
}

Model md_multiply(Model a, Model b) {
    precise REAL c0 = a.c.x * b.c.x;
    precise REAL c1 = a.c.x * b.c.y + a.c.y * b.c.x;
    precise REAL c2 = a.c.x * b.c.z + a.c.y * b.c.y + a.c.z * b.c.x;
    precise REAL c3 = a.c.y * b.c.z + a.c.z * b.c.y;
    precise REAL c4 = a.c.z * b.c.z;
    precise REAL3 aside = a.c.x * b.aside + b.c.x * a.aside;
    REAL size_a = md_size(a), size_b = md_size(b), tube_a = md_sum(a.aside), tube_b = md_sum(b.aside);
    REAL left_out = abs(c4) + tube_a * (md_change(b) + tube_b) + tube_b * md_change(a) +
                    4.0 * IM_ROUNDING * size_a * size_b;
    REAL most_b = size_b + b.error;
    REAL error = a.error * most_b + size_a * b.error + abs(c3) + left_out;
    REAL slope_error = a.slope_error * most_b + a.error * (md_slope(b) + b.slope_error) +
                       size_a * b.slope_error + md_slope(a) * b.error + 3.0 * abs(c3) +
                       4.0 * left_out;
    return Model(REAL3(c0, c1, c2), aside, md_up(error), md_up(slope_error));
}

Model md_square(Model a) {
    precise REAL twice = 2.0 * a.c.x;
    precise REAL c0 = a.c.x * a.c.x;
    precise REAL c1 = twice * a.c.y;
    precise REAL c2 = twice * a.c.z + a.c.y * a.c.y;
    precise REAL c3 = 2.0 * a.c.y * a.c.z;
    precise REAL c4 = a.c.z * a.c.z;
    precise REAL3 aside = twice * a.aside;
    REAL size = md_size(a), tube = md_sum(a.aside);
    REAL left_out = c4 + tube * (2.0 * md_change(a) + tube) + 4.0 * IM_ROUNDING * size * size;
    REAL error = a.error * (2.0 * size + a.error) + abs(c3) + left_out;
    REAL slope_error = 2.0 * (a.slope_error * (size + a.error) + a.error * md_slope(a)) +
                       3.0 * abs(c3) + 4.0 * left_out;
    return Model(REAL3(c0, c1, c2), aside, md_up(error), md_up(slope_error));
}

REAL2 md_range(Model a) {
    REAL off = md_up(md_change(a) + md_off(a) + IM_ROUNDING * abs(a.c.x));
    return REAL2(a.c.x - off, a.c.x + off);
}

Model md_without_bound(Model a) {
    a.error = a.slope_error = IM_INFINITY;
    return a;
}
