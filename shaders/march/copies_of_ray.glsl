// What a ray's beams found to matter in them: lists of the last level, and above them in the texture
// those of the level before it.
uniform int first_lists_row;

LIST list_of_first(ivec2 block, int which) {
    ivec2 above = ivec2(0, first_lists_row);
    return stored_list(above + first_of_list(block, which, 2, FIRST_SLOTS), FIRST_SLOTS);
}

// Of the ray's block, whose front and middle end there.
BeamLists lists_of_beam(ivec2 block, float front_end, float middle_end) {
    ivec2 larger = block * BLOCK / FIRST_BLOCK;
    LIST middle = list_of_first(larger, 0), all = list_of_first(larger, 1);
    LIST front = stored_list(first_of_list(block, 0, 1, LAST_SLOTS), LAST_SLOTS);
    // Too long: what it was made from.
    if (front.x < 0.0) front = front_end <= middle_end ? middle : all;
    return BeamLists(front, middle, all, front_end, middle_end);
}
