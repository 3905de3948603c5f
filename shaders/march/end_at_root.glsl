// The ray ends at its root; the shade pass takes the gradient there.

RayState found(RayState s) {
    s.low = 0.5 * (s.low + s.high);
    return finish(s, VERDICT_HIT);
}

vec3 sample_direction(RayState s, Ray ray) {
    return ray.direction;
}

RayState take_slope(RayState s, vec2 f) {
    return s;
}
