// The lists of later levels are made from one of the larger beam's lists. The smallest beams have
// no more than a front; their lists are made from the one that reaches to its end. See beam_by_intervals.glsl.
uniform sampler2D beam_texture;

void enter_parent(ivec2 block, vec2 at) {
    vec4 part = textureLod(beam_texture, at, 0.0);
    int which = LISTS_OF_A_BLOCK == 1 && part.z <= part.w ? 0 : 1;
    enter_list(LIST_OF_LARGER(block * BLOCK / LARGER_BLOCK, which));
}
