// Marches and shades in one draw, for rays that end within one pass. If a ray does not, its record
// says so, and the tile has to be drawn in passes.

void main() {
    Ray ray = pixel_ray();
    enter_beam(ray);
    RayState s = march(ray, begin(ray));
    if (s.phase != PHASE_DONE) s.verdict = VERDICT_UNFINISHED;
#ifdef LISTS
    choose_list(s.low);
#endif
    shade_ray(ray, s);
}
