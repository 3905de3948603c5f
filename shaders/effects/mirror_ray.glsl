// Mirrors the ray of a pixel at its end. Needs load_surface.glsl.

Ray mirrored_ray() {
    SurfacePoint p = load_surface();
    bool goes_on = is_on_surface(p);
#ifdef MIRRORS
    // Only rays that end on a surface which mirrors the others: MIRRORS has a bit for each of those.
    int k = int(IM_TEXEL(surface_texture_3, ivec2(pixel_centre)).z);
    goes_on = goes_on && ((MIRRORS >> k) & 1) != 0;
#endif
    Ray ray = eye_ray();
    ray.direction = reflect(ray.direction, p.normal);
    ray.anchor = p.position + p.offset * p.normal;
    vec2 inside = clip_to_bounds(ray.anchor, ray.direction);
    ray.t_near = max(inside.x, 0.0);
    ray.t_far = goes_on ? inside.y : -1.0;
    return ray;
}

Ray pixel_ray() {
    return mirrored_ray();
}
