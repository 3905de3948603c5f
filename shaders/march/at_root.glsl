// Ends the ray at its root.

#ifdef MARCH_TAKES_GRADIENT
// For long formulas: at its root the ray samples three more slopes, along the axes, and leaves them
// as the gradient in f_low and high. So no other shader holds the field, and the compiler meets its
// text once, with one derivative instead of three.

RayState found(RayState s, float root) {
    s.low = root;
    s.high = root;
    s.phase = PHASE_GRADIENT;
    s.refinements = 0; // counts the axes from here on
    return s;
}

vec3 sample_direction(RayState s, Ray ray) {
    if (s.phase != PHASE_GRADIENT) return ray.direction;
    return vec3(float(s.refinements == 0), float(s.refinements == 1), float(s.refinements == 2));
}

RayState take_derivative(RayState s, vec2 f) {
    if (s.refinements == 0) s.f_low.x = f.y;
    if (s.refinements == 1) s.f_low.y = f.y;
    if (s.refinements == 2) {
        s.high = f.y;
        return finish(s, VERDICT_HIT);
    }
    s.refinements += 1;
    return s;
}
#else
// The shade pass computes the gradient there.
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
#endif
