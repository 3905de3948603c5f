// One pass of rays that may take several passes.

uniform bool first_pass;

void march_pixel() {
    RayState s = finish(state_at(0.0), VERDICT_MISS);
    bool meets_surface = true;
#if defined(SETTLES) && defined(BRANCHES)
    vec4 part = part_of_beam(beam_texel(ivec2(pixel_centre) / BLOCK, SQUARE_BITS));
    meets_surface = part.x < part.y;
#endif
    if (meets_surface) {
        Ray ray = pixel_ray();
        enter_beam(ray);
        s = begin(ray);
#ifdef SETTLES
        s = begin_in_slab(ray, s);
#endif
        if (!first_pass) s = load_state();
        s = march(ray, s);
    }
    store_state(s);
}
