// Lists of elements as copies in a texture. A list is a rectangle 16 texels wide: each 16 elements
// take TEXELS rows, one for each of their texels. Its last place holds the number of elements, or -1
// if there are more elements than places. The lists of a block lie one above the other, the front's
// first.
//
// A LIST is the number of elements, and the texel where they begin.

ivec2 first_of_list(ivec2 block, int which, int lists, int slots) {
    int rows = slots / 16 * TEXELS;
    return ivec2(16 * block.x, (block.y * lists + which) * rows);
}

LIST stored_list(ivec2 first, int slots) {
    int rows = slots / 16 * TEXELS;
    float count = texelFetch(array0_lists, first + ivec2(15, rows - TEXELS), 0).x;
    return LIST(count, vec2(first));
}
