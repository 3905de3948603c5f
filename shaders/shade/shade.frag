// Shades finished rays; where march and picture are one draw, it marches them first. If a ray does not
// end within that draw, its record says so, and the tile has to be drawn in passes.

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
