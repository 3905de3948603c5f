// The part of a ray that its beam left to march, see beam.frag.
uniform sampler2D beam_texture;

void enter_beam(inout Ray ray) {
    ivec2 at = beam_texel(ivec2(pixel_centre) / BLOCK, SQUARE_BITS);
    vec4 part = texelFetch(beam_texture, at, 0);
    ray.t_near = max(ray.t_near, part.x * ray.to_eye);
    ray.t_far = part.x < part.y ? min(ray.t_far, part.y * ray.to_eye) : ray.t_near - 1.0;
#ifdef LISTS
    vec2 ends = part.zw * ray.to_eye;
    LIST all = all_of_beam(at);
    beam_lists = BeamLists(front_of_beam(at), middle_of_beam(at), all, ends.x, ends.y);
    enter_list(all);
#endif
}
