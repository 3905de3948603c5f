// The next ray of a pixel's path. Needs path.glsl, may_meet() and least_begin().

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
