// Eq. 3 of Singh & Narayanan 2010: the hull of the values at both ends and of their linear
// extensions to the middle holds 0. Sees touching roots, and may see some that are not there.
bool root_exists(float t0, vec2 f0, float t1, vec2 f1) {
    float half_step = 0.5 * (t1 - t0);
    float q = f0.x + f0.y * half_step;
    float r = f1.x - f1.y * half_step;
    float least = min(min(f0.x, f1.x), min(q, r));
    float most = max(max(f0.x, f1.x), max(q, r));
    return least <= 0.0 && most >= 0.0;
}
