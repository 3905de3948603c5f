// Interval marching, after Knoll et al. 2009. A piece of the ray over which the bound on F excludes
// 0 has no root. If the bound on dF/dt excludes 0, the piece has one root if F changes its sign
// from end to end, and otherwise none. In doubt the piece is halved, down to the shortest, where F
// counts as 0. So no root is missed, except by rounding in the signs at the ends of pieces.

float next_sample(RayState s) {
    return s.high;
}

RayState advance(RayState s, Ray ray, float t, float f, Bounds bounds) {
    float h = s.high - s.low;
    bool changes = (f < 0.0) != (s.f_low.x < 0.0);
    bool monotone = excludes_0(bounds.derivative);
    bool is_finest = h <= finest_at(t);
    if (excludes_0(bounds.value) || monotone && !changes) return move_on(s, ray, t, f, 2.0 * h);
    if (monotone) return isolated(s, s.low, s.high, t);
    if (!is_finest) return cut(s, 0.5 * h);
    return touches_at(s, ray, 0.5 * (s.low + s.high), bounds);
}
