// The next ray of a pixel's path, as far as it may meet this surface: in matter whose rank is less, glass
// is not there. `eye_ray` is pixel_ray() of march/ray.glsl. Needs path.glsl and matter.glsl.

float ray_begin(Ray ray) {
    return 0.0;
}

bool may_meet(Path path) {
#ifdef GLASS
    return goes_on(path) && (path.matter == SURFACE || rank_of(SURFACE) < rank_of(path.matter));
#else
    return goes_on(path);
#endif
}

Ray pixel_ray() {
    Path path = load_path();
    Ray ray = eye_ray();
    ray.anchor = path.position;
    ray.direction = path.direction;
    vec2 inside = clip_to_bounds(ray.anchor, ray.direction);
#ifdef GLASS
    ray.t_near = max(inside.x, path.off);
#else
    // What lies on the glass that the ray has come through, or nearer to it than rays begin.
    ray.t_near = max(inside.x, -2.0 * path.off);
#endif
    ray.t_far = may_meet(path) ? inside.y : -1.0;
    ray.to_eye = 0.0;
    return ray;
}
