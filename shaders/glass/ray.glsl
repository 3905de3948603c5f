// The next ray of a pixel's path. `eye_ray` is pixel_ray() of march/ray.glsl. Needs path.glsl, may_meet()
// and least_begin().

float ray_begin(Ray ray) {
    return 0.0;
}

Ray pixel_ray() {
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
