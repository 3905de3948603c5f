// Mirrors the ray of a pixel at its end. `eye_ray` is pixel_ray() of march/ray.glsl. Needs
// load_surface.glsl.

float ray_begin(Ray ray) {
    return 0.0;
}

Ray pixel_ray() {
    SurfacePoint p = load_surface();
    Ray ray = eye_ray();
    ray.direction = reflect(ray.direction, p.normal);
    ray.anchor = p.position + p.offset * p.normal;
    vec2 inside = clip_to_bounds(ray.anchor, ray.direction);
    ray.t_near = max(inside.x, 0.0);
    ray.t_far = is_on_surface(p) ? inside.y : -1.0;
    return ray;
}
