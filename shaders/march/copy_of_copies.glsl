// Lists of later levels are made from one of the larger beam's, see beam.frag.
uniform sampler2D beam_texture;

void enter_parent(ivec2 block) {
    vec4 part = texelFetch(beam_texture, block, 0);
    int which = part.z <= part.w ? 0 : 1;
    enter_list(LIST(0.0, vec2(first_of_list(block * BLOCK / PARENT_BLOCK, which, 2, FIRST_SLOTS))));
}
