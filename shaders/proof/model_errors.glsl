// What the errors of models have in common. Needs interval/arithmetic.glsl.
//
// An error is a sum of products of numbers that are not negative, some twenty roundings deep at
// most: two millionths more than it comes to is no less than it is. What drivers flush to 0, of the
// model's coefficients too, is less than 2^-126 each, and each error more than a hundred of these.
REAL md_up(REAL error) {
    precise REAL up = error * 1.000002 + 1.0e-36;
    return up;
}
