// The part of a ray that its beam left to march, see beam.frag.
uniform sampler2D beam_texture;
#ifdef LISTS
uniform sampler2D beam_lists_texture;
uniform sampler2D beam_all_texture;
#endif

void enter_beam(inout Ray ray) {
    ivec2 at = beam_texel(ivec2(pixel_centre) / BLOCK, SQUARE_BITS);
    vec4 part = texelFetch(beam_texture, at, 0);
    ray.t_near = max(ray.t_near, part.x * ray.to_eye);
    ray.t_far = part.x < part.y ? min(ray.t_far, part.y * ray.to_eye) : ray.t_near - 1.0;
#ifdef LISTS
    vec4 lists = texelFetch(beam_lists_texture, at, 0);
    vec2 all = texelFetch(beam_all_texture, at, 0).xy;
    vec2 ends = part.zw * ray.to_eye;
    beam_lists = BeamLists(lists.xy, lists.zw, all, ends.x, ends.y);
    enter_list(all);
#endif
}
