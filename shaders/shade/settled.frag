// Finds and shades the first roots of rays of settled blocks in one draw, as fused.frag does others.

void main() {
    Ray ray = pixel_ray();
    RayState s = begin_in_slab(ray, state_at(0.0));
    s = march(ray, s);
    if (s.phase != PHASE_DONE) s.verdict = VERDICT_UNFINISHED;
    shade_ray(ray, s);
}
