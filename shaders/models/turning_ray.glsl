// The models of ray.glsl, but aside + s turn is the change with each of the points'
// coordinates. They cost twice as much, and near nodes and double lines, where terms cancel, they
// prove what the others leave. Needs interval/arithmetic.glsl and point.glsl.
//
// Coefficients of products, and those left out, are off by at most 4 times 2^-p of the product of
// both sums of sizes; those of sums by 2^-p of themselves. The points' coordinates are off by
// linear functions of s, whose slopes are at most their largest values. So the slope of what is
// left out is at most four times its size.
#undef MODEL
#define MODEL Model
struct Model {
    REAL3 c, aside, turn;
    REAL error, slope_error;
};

// Bounds the change along the piece.
REAL md_change(Model a) {
    return abs(a.c.y) + abs(a.c.z);
}

REAL md_size(Model a) {
    return md_sum(a.c) + md_sum(a.aside) + md_sum(a.turn);
}

// The steepest slope in s.
REAL md_slope(Model a) {
    return abs(a.c.y) + 2.0 * abs(a.c.z) + md_sum(a.aside) + 2.0 * md_sum(a.turn);
}

// Bounds how far F may be from the quadratic.
REAL md_off(Model a) {
    return md_up(a.error + md_sum(a.aside) + md_sum(a.turn));
}

// The same of its slope, where the slopes of the points' coordinates are `apart` times their
// sizes.
REAL md_slope_off(Model a, REAL apart) {
    REAL turns = md_sum(a.turn);
    return a.slope_error + apart * (md_sum(a.aside) + turns) + turns;
}

Model md_coordinate(REAL c, REAL l, REAL3 aside, REAL off) {
    return Model(REAL3(c, l, 0.0), aside, REAL3(0.0), off, off);
}

Model md_of_Model(REAL value, REAL rounding) {
    return Model(REAL3(value, 0.0, 0.0), REAL3(0.0), REAL3(0.0), md_up(rounding * abs(value)),
                 md_up(0.0));
}

Model md_negate(Model a) {
    return Model(-a.c, -a.aside, -a.turn, a.error, a.slope_error);
}

Model md_add(Model a, Model b) {
    precise REAL3 c = a.c + b.c;
    precise REAL3 aside = a.aside + b.aside;
    precise REAL3 turn = a.turn + b.turn;
    Model r = Model(c, aside, turn, 0.0, 0.0);
    r.error = md_up(a.error + b.error + IM_ROUNDING * md_size(r));
    r.slope_error = md_up(a.slope_error + b.slope_error + IM_ROUNDING * md_slope(r));
    return r;
}

Model md_shift(Model a, REAL by, REAL rounding) {
    precise REAL c = a.c.x + by;
    REAL off = rounding * abs(by) + IM_ROUNDING * abs(c);
    return Model(REAL3(c, a.c.y, a.c.z), a.aside, a.turn, md_up(a.error + off), a.slope_error);
}

Model md_scale(REAL by, Model a, REAL rounding) {
    precise REAL3 c = by * a.c;
    precise REAL3 aside = by * a.aside;
    precise REAL3 turn = by * a.turn;
    REAL most = rounding + IM_ROUNDING;
    return Model(c, aside, turn, md_up(abs(by) * (a.error + most * (md_size(a) + a.error))),
                 md_up(abs(by) * (a.slope_error + most * (md_slope(a) + a.slope_error))));
}

// By a power of two.
Model md_scale_by_power(REAL by, Model a) {
    precise REAL3 c = by * a.c;
    precise REAL3 aside = by * a.aside;
    precise REAL3 turn = by * a.turn;
    return Model(c, aside, turn, md_up(abs(by) * a.error), md_up(abs(by) * a.slope_error));
}

Model md_multiply(Model a, Model b) {
    precise REAL c0 = a.c.x * b.c.x;
    precise REAL c1 = a.c.x * b.c.y + a.c.y * b.c.x;
    precise REAL c2 = a.c.x * b.c.z + a.c.y * b.c.y + a.c.z * b.c.x;
    precise REAL c3 = a.c.y * b.c.z + a.c.z * b.c.y;
    precise REAL c4 = a.c.z * b.c.z;
    precise REAL3 aside = a.c.x * b.aside + b.c.x * a.aside;
    precise REAL3 turn =
        a.c.x * b.turn + b.c.x * a.turn + a.c.y * b.aside + b.c.y * a.aside;
    REAL change_a = md_change(a), change_b = md_change(b);
    REAL aside_a = md_sum(a.aside), aside_b = md_sum(b.aside);
    REAL turn_a = md_sum(a.turn), turn_b = md_sum(b.turn);
    REAL tube_a = aside_a + turn_a, tube_b = aside_b + turn_b;
    REAL size_a = abs(a.c.x) + change_a + tube_a, size_b = abs(b.c.x) + change_b + tube_b;
    REAL slope_a = abs(a.c.y) + 2.0 * abs(a.c.z) + aside_a + 2.0 * turn_a;
    REAL slope_b = abs(b.c.y) + 2.0 * abs(b.c.z) + aside_b + 2.0 * turn_b;
    REAL left_out = tube_a * tube_b + aside_a * abs(b.c.z) + turn_a * change_b +
                    aside_b * abs(a.c.z) + turn_b * change_a;
    REAL rounding = 4.0 * IM_ROUNDING * size_a * size_b;
    REAL error = a.error * (size_b + b.error) + size_a * b.error + abs(c3) + abs(c4) + left_out +
                 rounding;
    REAL slope_error = a.slope_error * (size_b + b.error) + a.error * (slope_b + b.slope_error) +
                       size_a * b.slope_error + slope_a * b.error + 3.0 * abs(c3) +
                       4.0 * (abs(c4) + left_out + rounding);
    return Model(REAL3(c0, c1, c2), aside, turn, md_up(error), md_up(slope_error));
}

Model md_square(Model a) {
    precise REAL c0 = a.c.x * a.c.x;
    precise REAL c1 = 2.0 * a.c.x * a.c.y;
    precise REAL c2 = 2.0 * a.c.x * a.c.z + a.c.y * a.c.y;
    precise REAL c3 = 2.0 * a.c.y * a.c.z;
    precise REAL c4 = a.c.z * a.c.z;
    precise REAL3 aside = 2.0 * a.c.x * a.aside;
    precise REAL3 turn = 2.0 * a.c.x * a.turn + 2.0 * a.c.y * a.aside;
    REAL change = md_change(a), aside_a = md_sum(a.aside), turn_a = md_sum(a.turn);
    REAL tube_a = aside_a + turn_a, size = abs(a.c.x) + change + tube_a;
    REAL slope = abs(a.c.y) + 2.0 * abs(a.c.z) + aside_a + 2.0 * turn_a;
    REAL left_out = tube_a * tube_a + 2.0 * (aside_a * abs(a.c.z) + turn_a * change);
    REAL rounding = 4.0 * IM_ROUNDING * size * size;
    REAL error = a.error * (2.0 * size + a.error) + abs(c3) + c4 + left_out + rounding;
    REAL slope_error = 2.0 * a.slope_error * (size + a.error) + 2.0 * a.error * slope +
                       3.0 * abs(c3) + 4.0 * (c4 + left_out + rounding);
    return Model(REAL3(c0, c1, c2), aside, turn, md_up(error), md_up(slope_error));
}

REAL2 md_range(Model a) {
    REAL off = md_up(md_change(a) + md_off(a) + IM_ROUNDING * abs(a.c.x));
    return REAL2(a.c.x - off, a.c.x + off);
}

Model md_without_bound(Model a) {
    a.error = a.slope_error = IM_INFINITY;
    return a;
}
