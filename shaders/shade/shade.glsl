// Shades a finished ray.

layout(location = 0) out vec4 color;
layout(location = 1) out uint record;

// Largest component of g, to scale by: |g| may leave float's range long before its direction does.
float magnitude(vec3 g) {
    return max(max(abs(g.x), abs(g.y)), abs(g.z));
}

void shade_ray(Ray ray, RayState s) {
    color = background;
    Hit hit = hit_at(ray_point(ray, s.low), -ray.direction, s.low, false);
#ifdef SECTIONS
    hit.cap = cap_of(s);
#endif
    int verdict = s.verdict;
    if (verdict == VERDICT_HIT) {
        vec3 g = surface_gradient(s, hit.position);
        // Must precede the clamp, which turns NaN into a number on some drivers.
        bool known = !(im_is_nan(g.x) || im_is_nan(g.y) || im_is_nan(g.z));
        g = clamp(g, -IM_SATURATION, IM_SATURATION);
        float size = magnitude(g);
        if (known && size > 0.0) {
            hit.normal = normalize(g / size);
            hit.inside = dot(hit.normal, ray.direction) > 0.0; // F rises along the ray
            if (hit.inside) hit.normal = -hit.normal;
        } else {
            verdict = VERDICT_ZERO_GRADIENT; // still a hit: lit as if it faced the viewer
        }
        color = vec4(shade(hit), 1.0);
    } else if (verdict == VERDICT_NAN) {
        color = vec4(1.0, 0.0, 1.0, 1.0); // no pixel lies silently: NaN is magenta,
    } else if (verdict == VERDICT_STEP_LIMIT) {
        color = vec4(1.0, 0.8, 0.0, 1.0); // the step limit amber
    }
    record = packed_record(verdict, s.evaluations);
    write_channels(ray, hit, verdict);
}
