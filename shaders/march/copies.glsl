// Lists of elements as copies in a texture. A list is a rectangle of 16 elements a row, TEXELS rows for
// each texel of an element, and its last place tells how many there are: -1 where there are more than
// places. A block's lists lie one above the other, that of the front first.
//
// A list is how many there are, and the texel where they begin.

ivec2 first_of_list(ivec2 block, int which, int lists, int slots) {
    int rows = slots / 16 * TEXELS;
    return ivec2(16 * block.x, (block.y * lists + which) * rows);
}

LIST stored_list(ivec2 first, int slots) {
    int rows = slots / 16 * TEXELS;
    float count = texelFetch(array0_lists, first + ivec2(15, rows - TEXELS), 0).x;
    return LIST(count, vec2(first));
}
