// Steps and tests of marching points.

#ifdef ADAPTIVE_STEPS
// Adaptive marching points, Eq. 2 of Singh & Narayanan 2010: f.x is S(p(t)), f.y is grad S . D.
float step_size(vec2 f) {
    float base = thresholds.x, near = thresholds.y, far = thresholds.z, horizon = thresholds.w;
    float value = abs(f.x);
    float beside = abs(f.y) < horizon ? 0.25 * base : 0.5 * base;
    return value < near ? beside : value > far ? 2.0 * base : base;
}
#else
// Marching points: the base step everywhere.
float step_size(vec2 f) {
    return thresholds.x;
}
#endif

#ifdef TAYLOR_TEST
// Eq. 3 of Singh & Narayanan 2010: whether 0 is in the hull of the values at both ends and their
// linear extensions to the middle. Sees touching roots, but may also see some that do not exist.
bool root_exists(float t0, vec2 f0, float t1, vec2 f1) {
    float half_step = 0.5 * (t1 - t0);
    float q = f0.x + f0.y * half_step;
    float r = f1.x - f1.y * half_step;
    float least = min(min(f0.x, f1.x), min(q, r));
    float most = max(max(f0.x, f1.x), max(q, r));
    return least <= 0.0 && most >= 0.0;
}
#else
// A root where the sign changes. Signs are compared, since a product could underflow to 0.
bool root_exists(float t0, vec2 f0, float t1, vec2 f1) {
    return (f0.x < 0.0) != (f1.x < 0.0);
}
#endif
