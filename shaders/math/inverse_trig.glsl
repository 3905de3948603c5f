// im_asin, im_acos, im_atan, im_atan2, im_angle. Needs bits.glsl.
//
// Arguments of asin and acos beyond +-1 come from rounding and count as +-1. The constants of pi
// are added in two floats, the small one first.

// asin(a) - a for a in [0, 1/2], with z = a*a. For a larger |x|, a = sqrt((1 - |x|)/2), whose
// square is exact: asin(|x|) = pi/2 - 2 asin(a).
float im_asin_excess(float a, float z) {
    precise float p = 4.2163199048e-2;
    p = p * z + 2.4181311049e-2;
    p = p * z + 4.5470025998e-2;
    p = p * z + 7.4953002686e-2;
    p = p * z + 1.6666752422e-1;
    precise float y = a * z * p;
    return y;
}

// (turn + turn_rest) - 2*(a + excess), without the rounding of the first difference.
float im_turned_back(float turn, float turn_rest, float a, float excess) {
    precise float y = turn - 2.0 * a;
    precise float lost = (turn - y) - 2.0 * a;
    y = y + (lost + (turn_rest - 2.0 * excess));
    return y;
}

float im_asin(float x) {
    precise float size = abs(x);
    size = IM_SELECT(size > 1.0, 1.0, size);
    bool large = size > 0.5;
    precise float z = IM_SELECT(large, 0.5 * (1.0 - size), size * size);
    precise float a = IM_SELECT(large, sqrt(z), size);
    float excess = im_asin_excess(a, z);
    precise float back = im_turned_back(1.57079637, -4.37113883e-8, a, excess);
    precise float y = IM_SELECT(large, back, a + excess);
    y = IM_SELECT(x < 0.0, -y, y);
    return y;
}

float im_acos(float x) {
    precise float size = abs(x);
    size = IM_SELECT(size > 1.0, 1.0, size);
    bool large = size > 0.5;
    precise float z = IM_SELECT(large, 0.5 * (1.0 - size), size * size);
    precise float a = IM_SELECT(large, sqrt(z), size);
    float excess = im_asin_excess(a, z);
    precise float asin_x = IM_SELECT(x < 0.0, -(a + excess), a + excess);
    precise float y = 1.57079637 - (asin_x + 4.37113883e-8);
    precise float back = im_turned_back(3.14159274, -8.74227766e-8, a, excess);
    precise float close = IM_SELECT(x < 0.0, back, 2.0 * asin_x);
    y = IM_SELECT(large, close, y);
    return y;
}

// The angle of the point (b, a), both not negative.
float im_angle_of_quadrant(float a, float b) {
    // Turns by 0, pi/4 or pi/2 into [-tan(pi/8), tan(pi/8)], with one division for all.
    bool steep = a > 2.41421356 * b;
    bool middle = a > 0.414213562 * b;
    float above = IM_SELECT(steep, -b, IM_SELECT(middle, a - b, a));
    float below = IM_SELECT(steep, a, IM_SELECT(middle, a + b, b));
    float turn = IM_SELECT(steep, 1.57079637, IM_SELECT(middle, 0.785398185, 0.0));
    float turn_rest = IM_SELECT(steep, -4.37113883e-8, IM_SELECT(middle, -2.18556941e-8, 0.0));
    precise float t = above / below;
    precise float z = t * t;
    precise float p = 8.05374449538e-2;
    p = p * z - 1.38776856032e-1;
    p = p * z + 1.99777106478e-1;
    p = p * z - 3.33329491539e-1;
    precise float y = turn + (t + (t * z * p + turn_rest));
    return y;
}

float im_atan(float x) {
    precise float y = im_angle_of_quadrant(abs(x), 1.0);
    y = IM_SELECT(x < 0.0, -y, y);
    return y;
}

// The angle of the point (b, a), 0 at the axis, pi where a = 0 and b < 0.
float im_atan2(float a, float b) {
    const float most = IM_LARGEST / 4.0; // of what can be added and multiplied
    float size = max(abs(a), abs(b));
    float scale = IM_SELECT(size > most, 0.25, IM_SELECT(size < 1.0e-30, 1073741824.0, 1.0));
    precise float rise = abs(a) * scale;
    precise float run = abs(b) * scale;
    bool rises_without_end = rise > most;
    bool runs_without_end = run > most;
    rise = IM_SELECT(rises_without_end, most, IM_SELECT(runs_without_end, 0.0, rise));
    run = IM_SELECT(runs_without_end, most, IM_SELECT(rises_without_end, 0.0, run));
    run = IM_SELECT(rise == 0.0 && run == 0.0, 1.0, run);
    precise float y = im_angle_of_quadrant(rise, run);
    precise float back = 3.14159274 - (y + 8.74227766e-8);
    y = IM_SELECT(b < 0.0, back, y);
    y = IM_SELECT(a < 0.0, -y, y);
    return y;
}

// The same, as the enclosures of interval/inverse_trig.glsl are the same up to whole turns.
float im_angle(float a, float b) {
    return im_atan2(a, b);
}
