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
