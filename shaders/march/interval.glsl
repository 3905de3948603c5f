// Interval marching, after Knoll et al. 2009. A piece of the ray where the bound on F does not hold
// 0 has no root; where that on dF/dt does not, it has one if F changes its sign from end to end and
// else none. In doubt the piece is halved, down to the shortest, where F is taken to touch 0. So no
// root is ever missed, but for rounding in the signs at the ends of pieces.

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
