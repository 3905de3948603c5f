// Adaptive marching points, Eq. 2 of Singh & Narayanan 2010: f.x is S(p(t)), f.y is grad S . D.
float step_size(vec2 f) {
    float base = thresholds.x, near = thresholds.y, far = thresholds.z, horizon = thresholds.w;
    float value = abs(f.x);
    float beside = abs(f.y) < horizon ? 0.25 * base : 0.5 * base;
    return value < near ? beside : value > far ? 2.0 * base : base;
}
