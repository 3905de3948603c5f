// Samples of a ray that marches by cubics: cubic.glsl. Rays of a group mostly begin, step or close in
// together: with BRANCHES each of the three goes its own way, without what the others take.

float next_sample(RayState s) {
    return s.high;
}

RayState advance(RayState s, Ray ray, float t, vec2 f) {
    float longest = clamp(0.25 * (ray.t_far - ray.t_near), cubics.w, cubics.y);
    s.evaluations += 1;
    if (s.phase == PHASE_GRADIENT) return take_derivative(s, f);
#ifdef SETTLES
    if (s.phase == PHASE_NEWTON) return step_by_newton(s, ray, t, f);
#endif
#ifdef ROUGH
    if (judge_by_intervals(s, ray, t, f, longest)) return s;
#endif
#ifdef BRANCHES
    if (s.phase == PHASE_START) return advance_by_cubic(s, ray, t, f, longest, true, false);
    if (s.phase == PHASE_REFINE) return advance_by_cubic(s, ray, t, f, longest, false, true);
    return advance_by_cubic(s, ray, t, f, longest, false, false);
#else
    bool starts = s.phase == PHASE_START, refines = s.phase == PHASE_REFINE;
    return advance_by_cubic(s, ray, t, f, longest, starts, refines);
#endif
}
