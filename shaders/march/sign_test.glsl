// A root where the sign changes. Signs are compared, since a product could underflow to 0.
bool root_exists(float t0, vec2 f0, float t1, vec2 f1) {
    return (f0.x < 0.0) != (f1.x < 0.0);
}
