// Rounds the errors of models up. Needs interval/arithmetic.glsl.
//
// An error is a sum of products of non-negative numbers, at most some twenty roundings deep, so two
// millionths more is an upper bound. Each number that drivers flush to 0, also among the model's
// coefficients, is below 2^-126; the constant is more than eighty of these.
REAL md_up(REAL error) {
    precise REAL up = error * 1.000002 + 1.0e-36;
    return up;
}

// Returns the y, at most 2, up to which g0 + y g1 + y^2 g2 is certainly positive from y = 0 on. All
// terms together may be off by `rounding`.
REAL first_reach(REAL g0, REAL g1, REAL g2, REAL rounding) {
    REAL disc = g1 * g1 - 4.0 * g0 * g2;
    REAL below = sqrt(max(disc, 0.0)) - g1;
    REAL root = 0.98 * 2.0 * g0 / below;
    REAL y = disc >= 0.0 && below > 0.0 && root < 2.0 ? root : REAL(2.0);
    precise REAL at_end = g0 + y * (g1 + y * g2);
    precise REAL lowest = g0 - 0.25 * g1 * g1 / g2; // where g2 > 0, at -g1 / (2 g2)
    bool dips = g2 > 0.0 && g1 < 0.0 && -g1 < 2.0 * g2 * y * 1.0001;
    bool holds = g0 > rounding && at_end > rounding && (!dips || lowest > rounding);
    return holds ? y : REAL(0.0);
}
