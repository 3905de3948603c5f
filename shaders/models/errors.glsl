// Rounds the errors of models up. Needs interval/arithmetic.glsl.
//
// An error is a sum of products of non-negative numbers, at most some twenty roundings deep, so two
// millionths more is an upper bound. Each number that drivers flush to 0, also among the model's
// coefficients, is below 2^-126; the constant is more than eighty of these.
REAL md_up(REAL error) {
    precise REAL up = error * 1.000002 + 1.0e-36;
    return up;
}
