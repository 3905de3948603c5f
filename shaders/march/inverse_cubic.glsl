// Returns the zero of F as a part of h, in (0, 1), if t is a cubic of F; f0 and f1 differ in sign.
float inverse_cubic(vec2 f0, vec2 f1, float h) {
    float rise = f1.x - f0.x;
    float u = -f0.x / rise, v = 1.0 - u;
    float x = u * u * (3.0 - 2.0 * u) + u * v * (rise / h) * (v / f0.y - u / f1.y);
    return x > 0.0 && x < 1.0 ? x : clamp(u, 0.01, 0.99);
}
