// Restricts a ray to the part that it needs to march: of beams, what its own left, see
// beam_by_intervals.glsl; otherwise all of the bounds.
void enter_beam(inout Ray ray) {
#ifdef BEAMS
    ivec2 at = beam_texel(ivec2(pixel_centre) / BLOCK, SQUARE_BITS);
    vec4 part = part_of_beam(at);
    ray.t_near = max(ray.t_near, part.x * ray.to_eye);
    ray.t_far = part.x < part.y ? min(ray.t_far, part.y * ray.to_eye) : ray.t_near - 1.0;
#ifdef LISTS
    vec2 ends = part.zw * ray.to_eye;
#ifdef COPIES
    beam_lists = lists_of_beam(ivec2(pixel_centre) / BLOCK, ends.x, ends.y);
#else
    beam_lists = BeamLists(front_of_beam(at), middle_of_beam(at), all_of_beam(at), ends.x, ends.y);
#endif
    enter_list(beam_lists.all);
#endif
#endif
#ifdef ENDS_BEFORE
    // No farther than to what is seen of the surfaces before this one. Needs surfaces/way.glsl.
    ray.t_far = min(ray.t_far, (way_before() - surface_way.y * ray.to_eye) / surface_way.x);
#endif
}
