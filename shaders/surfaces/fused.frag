// shade/fused.frag for one surface among several: each draws over those before it where it is nearer. Needs
// shared_way(), seen_way.glsl and keep_nearest().
void main() {
    Ray ray = pixel_ray();
    enter_beam(ray);
    RayState s = march(ray, begin(ray));
    if (s.phase != PHASE_DONE) s.verdict = VERDICT_UNFINISHED;
#ifdef LISTS
    choose_list(s.low);
#endif
    shade_ray(ray, s);
    // Rays that gave up end there, too: what is before that counts, what is behind it doesn't.
    way = s.verdict == VERDICT_MISS ? NO_END : shared_way(ray, s.low);
    keep_nearest(ray, s);
}
