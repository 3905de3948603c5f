// The part of a ray that its beam left to march, see beam.frag.
uniform sampler2D beam_texture;

void enter_beam(inout Ray ray) {
    vec4 part = texelFetch(beam_texture, ivec2(pixel_centre) / BLOCK, 0);
    ray.t_near = max(ray.t_near, part.x * ray.to_eye);
    ray.t_far = part.x < part.y ? min(ray.t_far, part.y * ray.to_eye) : ray.t_near - 1.0;
#ifdef LISTS
    enter_list(part.zw);
#endif
}
