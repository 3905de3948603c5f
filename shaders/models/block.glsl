// Models of F over a piece of a block's beam. With u and v from -1 to 1 across the block and s from
// -1 to 1 along it, F is
//   c + l (u, v, s) + d (u^2, v^2, s^2) + o (u v, u s, v s)
// up to `error`, and its slope in s up to `slope_error`. Needs interval/arithmetic.glsl.
//
// Coefficients of products are off by at most 4 times 2^-24 of the product of both sums of sizes,
// those of sums by 2^-24 of themselves; slopes in s by twice that. Terms of third and fourth degree
// are products of terms of lower degree, and so are their slopes: pieces that hold roots are thin, so
// that F changes little in s.
#undef MODEL
#define MODEL Model
struct Model {
    float c;
    vec3 l, d, o;
    float linear, square; // sums of sizes: of l, and of d and o
    float error, slope_error;
};

float md_sum(vec3 a) {
    return abs(a.x) + abs(a.y) + abs(a.z);
}

Model md_model(float c, vec3 l, vec3 d, vec3 o, float error, float slope_error) {
    return Model(c, l, d, o, md_sum(l), md_sum(d) + md_sum(o), error, slope_error);
}

Model md_of_Model(float value, float rounding) {
    return md_model(value, vec3(0.0), vec3(0.0), vec3(0.0), md_up(rounding * abs(value)),
                    md_up(0.0));
}

float md_size(Model a) {
    return abs(a.c) + a.linear + a.square;
}

// The steepest slope in s of terms of second degree.
float md_turn(Model a) {
    return 2.0 * abs(a.d.z) + abs(a.o.y) + abs(a.o.z);
}

// The steepest slope of the model in s.
float md_slope(Model a) {
    return abs(a.l.z) + md_turn(a);
}

Model md_negate(Model a) {
    return Model(-a.c, -a.l, -a.d, -a.o, a.linear, a.square, a.error, a.slope_error);
}

Model md_add(Model a, Model b) {
    precise float c = a.c + b.c;
    precise vec3 l = a.l + b.l;
    precise vec3 d = a.d + b.d;
    precise vec3 o = a.o + b.o;
    Model r = md_model(c, l, d, o, 0.0, 0.0);
    r.error = md_up(a.error + b.error + IM_ROUNDING * md_size(r));
    r.slope_error = md_up(a.slope_error + b.slope_error + IM_ROUNDING * md_slope(r));
    return r;
}

Model md_shift(Model a, float by, float rounding) {
    precise float c = a.c + by;
    a.c = c;
    a.error = md_up(a.error + rounding * abs(by) + IM_ROUNDING * abs(c));
    return a;
}

Model md_scale(float by, Model a, float rounding) {
    precise float c = by * a.c;
    precise vec3 l = by * a.l;
    precise vec3 d = by * a.d;
    precise vec3 o = by * a.o;
    float size = abs(by), most = rounding + IM_ROUNDING;
    return Model(c, l, d, o, size * a.linear * 1.000001, size * a.square * 1.000001,
                 md_up(size * (a.error + most * (md_size(a) + a.error))),
                 md_up(size * (a.slope_error + most * (md_slope(a) + a.slope_error))));
}

// By a power of two.
Model md_scale_by_power(float by, Model a) {
    precise float c = by * a.c;
    precise vec3 l = by * a.l;
    precise vec3 d = by * a.d;
    precise vec3 o = by * a.o;
    float size = abs(by);
    return Model(c, l, d, o, size * a.linear, size * a.square, md_up(size * a.error),
                 md_up(size * a.slope_error));
}

Model md_multiply(Model a, Model b) {
    precise float c = a.c * b.c;
    precise vec3 l = a.c * b.l + b.c * a.l;
    precise vec3 d = a.c * b.d + b.c * a.d + a.l * b.l;
    precise vec3 o = a.c * b.o + b.c * a.o + a.l.xxy * b.l.yzz + b.l.xxy * a.l.yzz;
    float size_a = md_size(a), size_b = md_size(b);
    float cubic = a.linear * b.square + a.square * b.linear, quartic = a.square * b.square;
    float rounding = 3.0 * IM_ROUNDING * size_a * size_b;
    float error = cubic + quartic + a.error * (size_b + b.error) + size_a * b.error + rounding;
    float turn_a = md_turn(a), turn_b = md_turn(b);
    float cubic_slope = abs(a.l.z) * b.square + a.linear * turn_b + turn_a * b.linear +
                        a.square * abs(b.l.z);
    float quartic_slope = turn_a * b.square + a.square * turn_b;
    float slope_error = cubic_slope + quartic_slope + a.slope_error * (size_b + b.error) +
                        a.error * (md_slope(b) + b.slope_error) + size_a * b.slope_error +
                        md_slope(a) * b.error + 2.0 * rounding;
    return md_model(c, l, d, o, md_up(error), md_up(slope_error));
}

Model md_square(Model a) {
    precise float twice = 2.0 * a.c;
    precise float c = a.c * a.c;
    precise vec3 l = twice * a.l;
    precise vec3 d = twice * a.d + a.l * a.l;
    precise vec3 o = twice * a.o + 2.0 * a.l.xxy * a.l.yzz;
    float size = md_size(a), cubic = 2.0 * a.linear * a.square, quartic = a.square * a.square;
    float rounding = 3.0 * IM_ROUNDING * size * size;
    float error = cubic + quartic + a.error * (2.0 * size + a.error) + rounding;
    float turn = md_turn(a), cubic_slope = 2.0 * (abs(a.l.z) * a.square + a.linear * turn);
    float slope_error = cubic_slope + 2.0 * a.square * turn + 2.0 * a.slope_error * (size + a.error) +
                        2.0 * a.error * md_slope(a) + 2.0 * rounding;
    return md_model(c, l, d, o, md_up(error), md_up(slope_error));
}

vec2 md_range(Model a) {
    float off = md_up(a.linear + a.square + a.error + IM_ROUNDING * abs(a.c));
    return vec2(a.c - off, a.c + off);
}

Model md_without_bound(Model a) {
    a.error = a.slope_error = IM_INFINITY;
    return a;
}
