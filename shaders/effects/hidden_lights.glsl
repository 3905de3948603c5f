// What the state of a pixel's shadow rays tells of its lights. `verdict` has a bit for each light
// that is hidden; above these it counts the lights that were begun, and the rays that stay
// undecided. When all is done, only the bits are left, and the rays undecided are in `refinements`.
const int BEGUN_LIGHT = 1 << LIGHTS, UNDECIDED_RAY = 16 * BEGUN_LIGHT;

int begun_lights(RayState s) {
    return (s.verdict >> LIGHTS) & 15;
}

RayState finish_lights(RayState s) {
    s.refinements = s.verdict / UNDECIDED_RAY;
    return finish(s, s.verdict % BEGUN_LIGHT);
}

// Whether the pixel's rays have taken so much that the present one ends: it has met no sign of F but
// that of its light, so the light is seen. What the rays of earlier lights left may be used up.
// `before`: evaluations for other surfaces.
bool is_undecided(RayState s, int before) {
    return s.evaluations - before >= most_of_a_shadow_ray() * begun_lights(s);
}
