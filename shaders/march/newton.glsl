// Newton's steps to the root of a settled ray, from a guess in its slab [t_near, t_far], where F is monotone.
// The root stays between `low` and f_low.x. Every fourth step halves that, so that turns of the slope cost little.
// `precise` makes roots the same to the bit in one draw and in several.
RayState step_by_newton(RayState s, Ray ray, float t, vec2 f) {
    bool is_behind = (f.x < 0.0) == (f.y < 0.0);
    s.low = is_behind ? s.low : t;
    s.f_low.x = is_behind ? t : s.f_low.x;
    precise float newton = t - f.x / f.y;
    bool inside = newton >= s.low && newton <= s.f_low.x;
    bool close = inside && abs(newton - t) <= 4.0 * cubics.w || s.f_low.x - s.low <= cubics.w;
    bool steps = inside && (close || (s.evaluations & 3) != 3);
    s.high = steps ? newton : s.low + 0.5 * (s.f_low.x - s.low);
    if (close) return found(s, s.high);
    if (s.evaluations >= int(limits.y)) return finish(s, VERDICT_STEP_LIMIT);
    return s;
}
