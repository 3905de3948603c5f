// Shades the ends of the rays, for scenes with more than a plain light.

layout(location = 0) out vec4 color;
layout(location = 1) out uvec4 record; // see shade/record.glsl

void main() {
    Ray ray = pixel_ray();
    RayState s = load_state();
    SurfacePoint p = load_surface();
    Hit hit = hit_of(p);
    if (is_on_surface(p) || p.on_ground) {
        color = vec4(shade(ray, p, hit), 1.0);
    } else if (p.verdict == VERDICT_NAN) {
        color = vec4(1.0, 0.0, 1.0, 1.0); // no pixel lies silently: NaN is magenta,
    } else if (p.verdict == VERDICT_STEP_LIMIT) {
        color = vec4(1.0, 0.8, 0.0, 1.0); // the step limit amber
    } else {
        color = sky(ray.direction);
    }
    record = uvec4(packed_record(p.verdict, s.evaluations), further_record(p));
    write_channels(ray, hit, p.verdict);
}
