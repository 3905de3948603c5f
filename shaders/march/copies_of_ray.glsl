// What a ray's beams found to matter in them: lists of the last level, and of the level before it.

// The lists of the ray's block, whose front and middle end at these distances.
BeamLists lists_of_beam(ivec2 block, float front_end, float middle_end) {
    ivec2 larger = block * BLOCK / LARGER_BLOCK;
    LIST middle = LIST_OF_LARGER(larger, 0), all = LIST_OF_LARGER(larger, 1);
    LIST front = stored_list(LAST_LEVEL, block, 0, 1, LAST_SLOTS);
    // A list that is too long is replaced by the one that it was made from.
    if (front.x < 0.0) front = front_end <= middle_end ? middle : all;
    return BeamLists(front, middle, all, front_end, middle_end);
}
