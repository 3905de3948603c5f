// One pass of rays that may take several passes.

uniform bool first_pass;

void march_pixel() {
    Ray ray = pixel_ray();
    enter_beam(ray);
    RayState s;
    if (first_pass) {
        s = begin(ray);
    } else {
        s = load_state();
    }
    store_state(march(ray, s));
}
