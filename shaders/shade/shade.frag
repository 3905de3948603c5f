// Shades finished rays; where march and picture are one draw, it marches them first. If a ray does not
// end within that draw, its record says so, and the tile has to be drawn in passes.
void main() {
    Ray ray = pixel_ray();
#ifdef DRAWS_AT_ONCE
#ifdef SETTLED_RAYS
    RayState s = begin_in_slab(ray, state_at(0.0));
    s = march(ray, s);
#else
    enter_beam(ray);
    RayState s = march(ray, begin(ray));
#endif
    if (s.phase != PHASE_DONE) s.verdict = VERDICT_UNFINISHED;
#ifdef LISTS
    choose_list(s.low);
#endif
    shade_ray(ray, s);
#ifdef SURFACE
    // Rays that gave up end there, too: what is before that counts, what is behind it doesn't.
    way = s.verdict == VERDICT_MISS ? NO_END : shared_way(ray, s.low);
    keep_nearest(ray, s);
#endif
#else
    shade_ray(ray, load_state());
#endif
}
