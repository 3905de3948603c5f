// The method of rays that are all settled.
float next_sample(RayState s) {
    return s.high;
}

RayState advance(RayState s, Ray ray, float t, vec2 f) {
    s.evaluations += 1;
    if (s.phase == PHASE_GRADIENT) return take_derivative(s, f);
    return step_by_newton(s, ray, t, f);
}
