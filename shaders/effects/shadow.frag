// Shadow rays: from every place to every light that casts shadows, one light after the other. Any
// root will do, so there is no refinement (Singh & Narayanan 2010, IV-B); but a root that a test only
// suspects, the sign being the same at both ends, must still be there in half the step, down to the
// offset. Of the ray's state `bisections` counts the lights and `verdict` holds a bit for
// each that is hidden.

uniform bool first_pass;
uniform int evaluations_per_pass;

Ray shadow_ray(SurfacePoint p, int k) {
    LightRay light = light_at(k, p.position);
    Ray ray = Ray(p.position + p.offset * p.normal, light.direction, 0.0, 0.0);
    vec2 inside = clip_to_bounds(ray.anchor, ray.direction);
    ray.t_near = max(inside.x, 0.0);
    ray.t_far = min(inside.y, light.reach);
    return ray;
}

// The next light that may be hidden: none is where the surface turns away from it.
RayState next_light(RayState s, SurfacePoint p) {
    bool anything = is_on_surface(p) || p.on_ground;
    for (int k = s.bisections + 1; k < LIGHTS && anything; ++k) {
        if (((SHADOWS >> k) & 1) == 0) continue;
        if (dot(p.normal, light_at(k, p.position).direction) <= 0.0) continue;
        Ray ray = shadow_ray(p, k);
        if (!(ray.t_near < ray.t_far)) continue;
        s.bisections = k;
        s.low = ray.t_near;
        s.high = ray.t_near;
        s.phase = PHASE_START;
        return s;
    }
    return finish(s, s.verdict);
}

void main() {
    SurfacePoint p = load_surface();
    RayState s;
    if (first_pass) {
        s = next_light(RayState(0.0, vec2(0.0), 0.0, PHASE_DONE, 0, 0, -1), p);
    } else {
        s = load_state();
    }
    Ray ray = shadow_ray(p, max(s.bisections, 0));
    for (int k = 0; k < evaluations_per_pass; ++k) {
        if (s.phase == PHASE_DONE) break;
        vec2 f = sample_field(ray_point(ray, s.high), ray.direction);
        if (im_is_nan(f.y)) f.y = 0.0;
        s.evaluations += 1;
        bool hidden = s.phase == PHASE_MARCH && root_exists(s.low, s.f_low, s.high, f);
        bool suspected = hidden && (f.x < 0.0) == (s.f_low.x < 0.0);
        if (suspected && s.high - s.low > p.offset) {
            s.high = 0.5 * (s.low + s.high);
            continue;
        }
        bool ended = hidden || im_is_nan(f.x) || s.high >= ray.t_far ||
                     s.evaluations >= int(refinement.y);
        s.low = s.high;
        s.f_low = f;
        if (!ended) {
            s.high = min(s.low + step_size(f), ray.t_far);
            s.phase = PHASE_MARCH;
            ended = !(s.high > s.low);
        }
        if (!ended) continue;
        if (hidden) s.verdict += 1 << s.bisections;
        s = next_light(s, p);
        ray = shadow_ray(p, max(s.bisections, 0));
    }
    store_state(s);
}
