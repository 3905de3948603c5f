// Moves rays past where there is no root. Files before this one define end_of_free().

// Restarts a ray that stands where there is no root, at the next t where there may be one.
RayState pass_free(RayState s, Ray ray) {
    if (s.phase != PHASE_START && s.phase != PHASE_MARCH) return s;
    float t = end_of_free(ray, s.low);
    if (!(t > s.low)) return s;
    s.low = s.high = t;
    s.phase = PHASE_START;
    s.refinements = 0;
    s.other = vec3(0.0);
    s.open_end = 0.0;
    if (t >= ray.t_far) return finish(s, VERDICT_MISS);
    return s;
}
