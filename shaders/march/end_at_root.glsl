// Ends the ray at its root. The shade pass computes the gradient there.

RayState found(RayState s, float root) {
    s.low = root;
    return finish(s, VERDICT_HIT);
}

vec3 sample_direction(RayState s, Ray ray) {
    return ray.direction;
}

RayState take_derivative(RayState s, vec2 f) {
    return s;
}
