// Rays among several surfaces end where another one is seen: see ending_of_surface.frag. `whole_ray` is
// pixel_ray() of march/ray.glsl. Needs ending.glsl.
Ray pixel_ray() {
    Ray ray = whole_ray();
    ray.t_far = min(ray.t_far, IM_TEXEL(ending_texture, ivec2(pixel_centre)).y);
    return ray;
}
