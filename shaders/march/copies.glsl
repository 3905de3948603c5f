// Lists of elements as copies in a texture. A list is a rectangle 16 texels wide: each 16 elements
// take TEXELS rows, one for each of their texels. Its last place holds the number of elements, or -1
// if there are more elements than places. The lists of a block lie side by side, the front's first,
// and those of a level of beams above those of the level before.
//
// A LIST is the number of elements, and the middle of the texel where they begin.
uniform ivec3 list_rows; // where each level's lists begin

LIST stored_list(int level, ivec2 block, int which, int lists, int slots) {
    int rows = slots / 16 * TEXELS;
    ivec2 first = ivec2(16 * (block.x * lists + which), list_rows[level] + block.y * rows);
    vec2 at = (vec2(first) + 0.5) * list_texel;
    vec2 last = at + list_texel * vec2(15, rows - TEXELS);
    return LIST(textureLod(array0_lists, last, 0.0).x, at); // sampled as elements are
}

// The list for the front of a block of the largest beams, or for all of the block.
LIST list_of_first(ivec2 block, int which) {
    return stored_list(0, block, which, 2, FIRST_SLOTS);
}
