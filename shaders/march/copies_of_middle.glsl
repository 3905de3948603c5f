// The list for a beam between the largest and the smallest. A list that is too long is replaced by
// the one that it was made from.
LIST list_of_middle(ivec2 block, int which) {
    LIST list = stored_list(1, block, which, 2, MIDDLE_SLOTS);
    return list.x < 0.0 ? list_of_first(block * MIDDLE_BLOCK / FIRST_BLOCK, 1) : list;
}
