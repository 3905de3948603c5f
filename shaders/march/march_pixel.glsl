// One pass of rays that may take several passes.

uniform bool first_pass;

void march_pixel() {
    Ray ray = pixel_ray();
    enter_beam(ray);
    RayState s = begin(ray);
#ifdef SETTLES
    s = begin_in_slab(ray, s);
#endif
    if (!first_pass) s = load_state();
    store_state(march(ray, s));
}
