// im_sin, im_cos, im_tan on intervals. Needs arithmetic.glsl, divide.glsl, math/trig.glsl.
//
// The kernels' tests allow sine and cosine 1.2e-7 for arguments up to 1e5; 2^-21 = 4.8e-7 is
// counted. Beyond, they are only known to lie in [-1, 1].

#define IM_WAVE_ERROR 4.76837158e-7
#define IM_WAVE_REACH 1.0e5

// a / pi. The rounding here and in im_may_hold() is below 2^-22 |a / pi| + 2^-22; twice that is
// counted.
vec2 im_half_turns(vec2 a) {
    precise vec2 turns = a * 0.318309886;
    precise vec2 margin = abs(turns) * 4.76837158e-7 + 4.76837158e-7;
    precise vec2 outer = vec2(turns.x - margin.x, turns.y + margin.y);
    return outer;
}

// Whether `turns` may hold first + j / frequency for an integer j. True in doubt.
bool im_may_hold(vec2 turns, float first, float frequency) {
    precise vec2 steps = (turns - first) * frequency;
    return floor(steps.y) >= steps.x;
}

// Encloses a wave with crests at (crest + 2j) pi, from its values at the ends.
vec2 im_wave(vec2 a, vec2 inner, vec2 values, float crest) {
    vec2 turns = im_half_turns(inner);
    precise float lo = min(values.x, values.y) - IM_WAVE_ERROR;
    precise float hi = max(values.x, values.y) + IM_WAVE_ERROR;
    lo = IM_SELECT(im_may_hold(turns, crest + 1.0, 0.5), -1.0, max(lo, -1.0));
    hi = IM_SELECT(im_may_hold(turns, crest, 0.5), 1.0, min(hi, 1.0));
    return IM_SELECT2(max(-a.x, a.y) > IM_WAVE_REACH, vec2(-1.0, 1.0), vec2(lo, hi));
}

vec2 im_within_wave_reach(vec2 a) {
    return clamp(a, -IM_WAVE_REACH, IM_WAVE_REACH);
}

vec2 im_sin(vec2 a) {
    vec2 inner = im_within_wave_reach(a);
    return im_wave(a, inner, vec2(im_sin_cos(inner.x).x, im_sin_cos(inner.y).x), 0.5);
}

vec2 im_cos(vec2 a) {
    vec2 inner = im_within_wave_reach(a);
    return im_wave(a, inner, vec2(im_sin_cos(inner.x).y, im_sin_cos(inner.y).y), 0.0);
}

// The tangent rises from pole to pole.
vec2 im_tan(vec2 a) {
    vec2 inner = im_within_wave_reach(a);
    vec2 error = vec2(-IM_WAVE_ERROR, IM_WAVE_ERROR);
    vec2 low = im_sin_cos(inner.x);
    vec2 high = im_sin_cos(inner.y);
    float lo = im_divide(low.x + error, low.y + error).x;
    float hi = im_divide(high.x + error, high.y + error).y;
    bool pole = im_may_hold(im_half_turns(inner), 0.5, 1.0) || max(-a.x, a.y) > IM_WAVE_REACH;
    return IM_SELECT2(pole, IM_ENTIRE, vec2(lo, hi));
}
