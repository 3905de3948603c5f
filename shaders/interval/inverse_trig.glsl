// im_asin, im_acos, im_atan, im_atan2, im_angle on intervals. Needs arithmetic.glsl, divide.glsl,
// math/inverse_trig.glsl.
//
// The kernels' tests allow 1.7 ulps for asin and 2.6 for atan; 2^-20 of the result is counted,
// which is 8 ulps. acos: 2e-7, and 1.7 ulps of small results; 4e-7 and 2^-20 are counted.

vec2 im_asin(vec2 a) {
    return im_widen(vec2(im_asin(a.x), im_asin(a.y)), 9.53674316e-7);
}

vec2 im_acos(vec2 a) {
    precise vec2 r = vec2(im_acos(a.y), im_acos(a.x));
    precise vec2 margin = min(r * 9.53674316e-7, vec2(4.0e-7));
    precise vec2 outer = vec2(r.x - margin.x, r.y + margin.y);
    return outer;
}

vec2 im_atan(vec2 a) {
    vec2 inner = clamp(a, -IM_LARGEST, IM_LARGEST);
    return im_widen(vec2(im_atan(inner.x), im_atan(inner.y)), 9.53674316e-7);
}

// The angle of the points (b, a), going on beyond pi across the cut. A box is turned by quarters
// until it lies where b > 0, and there the angle is the atan of a quotient.
vec2 im_angle(vec2 a, vec2 b) {
    bool right = b.x > 0.0;
    bool up = !right && a.x > 0.0;
    bool down = !right && !up && a.y < 0.0;
    bool left = !right && !up && !down && b.y < 0.0;
    vec2 rise = IM_SELECT2(up, -b.yx, IM_SELECT2(down, b, a));
    vec2 run = IM_SELECT2(up, a, IM_SELECT2(down, -a.yx, b));
    vec2 turn = IM_SELECT2(up, vec2(1.57079625, 1.57079637), vec2(3.14159250, 3.14159274));
    turn = IM_SELECT2(down, vec2(-1.57079637, -1.57079625), turn);
    vec2 angle = im_atan(im_divide(rise, run));
    angle = IM_SELECT2(right, angle, im_add(turn, angle));
    angle.x = IM_SELECT(a.x >= 0.0, max(angle.x, 0.0), angle.x);
    return IM_SELECT2(right || up || down || left, angle, vec2(-3.14159274, 3.14159274));
}

vec2 im_atan2(vec2 a, vec2 b) {
    vec2 angle = im_angle(a, b);
    bool cut = a.x < 0.0 && a.y >= 0.0 && b.x <= 0.0;
    angle = IM_SELECT2(cut, vec2(-3.14159274, 3.14159274), angle);
    angle.y = IM_SELECT(a.y < 0.0, min(angle.y, 0.0), angle.y);
    angle = clamp(angle, -3.14159274, 3.14159274);
    return IM_SELECT2(a.x >= 0.0, im_not_negative(angle), angle);
}
