// Marches rays to their first roots, as a state machine: every turn of the loop samples the field
// once, at one place in the text. Drivers inline the field at each call, so a second call would
// double the compile time. The method is the file before this one: advance().

uniform bool first_pass;
uniform int evaluations_per_pass;

RayState begin(Ray ray) {
    RayState s = state_at(ray.t_near);
    bool empty = !(ray.t_near <= ray.t_far);
    return empty ? finish(s, VERDICT_MISS) : s;
}

void march_pixel() {
    Ray ray = pixel_ray();
    RayState s;
    if (first_pass) {
        s = begin(ray);
    } else {
        s = load_state();
    }
    // Software renderers go through a loop's body once more after a break at its top.
    int turns = s.phase == PHASE_DONE ? 0 : evaluations_per_pass;
    if (turns > 0) {
        do {
            float t = next_sample(s);
            vec2 f = sample_field(ray_point(ray, t), sample_direction(s, ray));
            s = advance(s, ray, t, f);
            turns -= 1;
        } while (turns > 0 && s.phase != PHASE_DONE);
    }
    store_state(s);
}
