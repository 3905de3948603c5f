#ifdef RAYS
// Chooses the list for the proof of a block whose rays run between two depths. A point at the depth
// `at` is in the list's part. That part surrounds roots from `first` on.
void choose_list_of_block(Beam way, ivec2 block, float first, float last, float at) {
    ivec2 texel = beam_texel(block * BLOCK / PARENT_BLOCK, PARENT_SQUARE_BITS);
    vec4 part = IM_TEXEL(beam_texture, texel);
    vec4 lists = IM_TEXEL(beam_lists_texture, texel);
    vec2 x, y, z;
    bool meets = box_of(way, at, at, x, y, z);
    bool holds = meets && first >= part.x && last <= part.y;
    if (!holds) {
        enter_all_elements();
        return;
    }
    vec2 list = last <= part.w ? lists.zw : IM_TEXEL(beam_all_texture, texel).xy;
    if (last <= part.z) list = lists.xy;
    enter_list_of_proof(list, x, y, z);
}
#else
// Chooses the list for the proof of a ray with this ending; call it after enter_beam(). If the
// surroundings of a root extend beyond the part where lists hold, all elements are used.
void choose_list_of_proof(Ray ray, Ending ended) {
    float around = tube.w + 2.0 * tube.z;
    float end = ended.hit ? ended.t + around : ray.t_far;
    bool holds = !ended.hit || ended.t - around > ray.t_near && end < ray.t_far;
    if (!holds) {
        enter_all_elements();
        return;
    }
    vec2 list = end <= beam_lists.middle_end ? beam_lists.middle : beam_lists.all;
    if (end <= beam_lists.front_end) list = beam_lists.front;
    vec3 p = ray_point(ray, ended.hit ? ended.t : 0.5 * (ray.t_near + ray.t_far));
    vec2 rounding = vec2(-tube.z, tube.z);
    enter_list_of_proof(list, REAL2(p.x + rounding), REAL2(p.y + rounding),
                        REAL2(p.z + rounding));
}
#endif
