// What the state of a pixel's shadow rays tells of its lights. `verdict` has a bit for each light
// that is hidden; above these it counts the lights that were begun, and the rays that stay
// undecided. When all is done, only the bits are left, and the rays undecided are in `refinements`.
const int BEGUN_LIGHT = 1 << LIGHTS, UNDECIDED_RAY = 16 * BEGUN_LIGHT;

// A ray that is undecided after so many evaluations has met no sign of F but that of its light, so
// the light is seen. Along a crease pieces of rays may stay open down to the finest.
const int MOST_OF_A_SHADOW_RAY = 2000;

int begun_lights(RayState s) {
    return (s.verdict >> LIGHTS) & 15;
}

RayState finish_lights(RayState s) {
    s.refinements = s.verdict / UNDECIDED_RAY;
    return finish(s, s.verdict % BEGUN_LIGHT);
}

// Whether the pixel's rays have taken so much that the present one ends. What the rays of earlier
// lights left may be used up. `before`: evaluations for other surfaces.
bool is_undecided(RayState s, int before) {
    int most = min(int(limits.y), MOST_OF_A_SHADOW_RAY);
    return s.evaluations - before >= most * begun_lights(s);
}
