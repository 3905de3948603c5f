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
