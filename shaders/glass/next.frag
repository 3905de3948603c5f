// Continues a path where its ray ended. Runs for paths that go on.
uniform int rays_left;

void main() {
    Path path = load_path();
    Ray ray = pixel_ray();
    RayState s = load_state();
    SurfacePoint p = end_of_ray(ray, s);
    path.evaluations += s.evaluations;
    bool hit = is_on_surface(p);
    float ahead = ground_ahead(ray.anchor, ray.direction);
    bool on_ground = ahead > 0.0 && (hit ? ahead < p.t : p.verdict == VERDICT_MISS);
    float end = on_ground ? min(ahead, ray.t_far) : hit ? p.t : ray.t_far;
    // The root is the ray's first one, so F keeps its sign before it.
    bool in_glass = hit ? p.inside : path.state == PATH_IN_GLASS;
    if (in_glass) path.weight *= absorbed(end);
    if (hit && !on_ground) {
        path = unless_faint(through(path, p, glass.y, absorbed(end), 1.0), rays_left);
    } else if (on_ground || p.verdict == VERDICT_MISS) {
        path = see_behind(path);
    } else { // no pixel lies silently
        bool nan = p.verdict == VERDICT_NAN;
        path.light += path.weight * (nan ? vec3(1.0, 0.0, 1.0) : vec3(1.0, 0.8, 0.0));
        path.state = PATH_LOST;
    }
    store_path(path);
}
