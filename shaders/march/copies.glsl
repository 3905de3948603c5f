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

#ifdef LARGER_BLOCK
// The list for a larger beam, the next one in size. A list that is too long is replaced by the one that
// it was made from.
LIST list_of_larger(ivec2 block, int which) {
#ifdef MIDDLE_BLOCK
    LIST list = stored_list(1, block, which, 2, MIDDLE_SLOTS);
    return list.x < 0.0 ? list_of_first(block * MIDDLE_BLOCK / FIRST_BLOCK, 1) : list;
#else
    return list_of_first(block, which);
#endif
}
#endif

#ifdef LAST_LEVEL
BeamLists lists_of_beam(ivec2 block, float front_end, float middle_end) {
    ivec2 larger = block * BLOCK / LARGER_BLOCK;
    LIST middle = list_of_larger(larger, 0), all = list_of_larger(larger, 1);
    LIST front = stored_list(LAST_LEVEL, block, 0, 1, LAST_SLOTS);
    // A list that is too long is replaced by the one that it was made from.
    if (front.x < 0.0) front = front_end <= middle_end ? middle : all;
    return BeamLists(front, middle, all, front_end, middle_end);
}
#endif
