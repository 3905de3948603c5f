// The next ray of a pixel's path. Needs path.glsl; among several surfaces paths/matter.glsl.

#ifdef FOLLOWS_PATHS
// What the ray of a path may meet of this surface: in matter whose rank is less, glass is not there.
bool may_meet(Path path) {
#ifdef GLASS
    return goes_on(path) && (path.matter == SURFACE || rank_of(SURFACE) < rank_of(path.matter));
#else
    return goes_on(path);
#endif
}

// The place on the path's ray from which on it may meet this surface.
float least_begin(Path path) {
#ifdef GLASS
    return path.off;
#else
    // What lies on the glass that the ray has come through, or nearer to it than rays begin.
    return -2.0 * path.off;
#endif
}
#else
bool may_meet(Path path) {
    return goes_on(path);
}

float least_begin(Path path) {
    return path.off;
}
#endif

Ray path_ray() {
    Path path = load_path();
    Ray ray = eye_ray();
    ray.anchor = path.position;
    ray.direction = path.direction;
    vec2 inside = clip_to_bounds(ray.anchor, ray.direction);
    ray.t_near = max(inside.x, least_begin(path));
    ray.t_far = may_meet(path) ? inside.y : -1.0;
    ray.to_eye = 0.0;
    return ray;
}

Ray pixel_ray() {
    return path_ray();
}
