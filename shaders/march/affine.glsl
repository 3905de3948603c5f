// Marching by first-order bounds. F in the middle of a piece and a bound on its slope bound F over
// the piece, as affine arithmetic does along a ray; the error shrinks with the square of the
// length. Where the slope keeps its sign, Newton's step with the interval of all slopes leaves the
// part of the piece that may hold a root. In doubt the piece is cut, down to the shortest, where F
// counts as 0.

float next_sample(RayState s) {
    return 0.5 * (s.low + s.high);
}

RayState advance(RayState s, Ray ray, float t, float f, Bounds bounds) {
    float h = s.high - s.low;
    bool is_finest = h <= finest_at(t);
    // Flips signs so that F > 0 before the piece.
    bool below = s.f_low.x < 0.0;
    vec2 slope = below ? -bounds.derivative.yx : bounds.derivative;
    vec2 value = below ? -bounds.value.yx : bounds.value;
    float middle = below ? -f : f;
    float to_end = s.high - t, from_start = t - s.low;
    // Lower bounds of F before and after the middle, and an upper bound at the end.
    float before = middle - max(slope.y, 0.0) * from_start;
    float after = middle + min(slope.x, 0.0) * to_end;
    float end = middle + slope.y * to_end;
    bool falls = slope.y < 0.0, climbs = slope.x > 0.0;
    if (value.x > 0.0 || climbs || middle > 0.0 && before > 0.0 && after > 0.0) {
        return move_on(s, ray, s.high, s.f_low.x, 2.0 * h);
    }
    if (falls && middle <= 0.0) return isolated(s, s.low, t, t - middle / slope.x);
    if (falls && end <= 0.0) return isolated(s, t, s.high, t - middle / slope.x);
    if (is_finest) return touches_at(s, ray, t, bounds);
    // Moves on to where F can first be 0.
    if (middle > 0.0 && before > 0.0) {
        return move_on(s, ray, t - middle / slope.x, s.f_low.x, 0.5 * h);
    }
    return cut(s, 0.5 * h);
}
