// Rays march no farther than to what is seen of the surfaces before this one. Needs shared_way().
uniform sampler2D surface_texture_3;

void enter_beam(inout Ray ray) {
    enter_own_beam(ray);
    float way = texelFetch(surface_texture_3, ivec2(pixel_centre), 0).x;
    ray.t_far = min(ray.t_far, (way - surface_way.y * ray.to_eye) / surface_way.x);
}
