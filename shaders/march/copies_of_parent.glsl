// What larger beams found to matter in them.

LIST front_of_parent(ivec2 block) {
    return stored_list(first_of_list(block, 0, 2, FIRST_SLOTS), FIRST_SLOTS);
}
LIST all_of_parent(ivec2 block) {
    return stored_list(first_of_list(block, 1, 2, FIRST_SLOTS), FIRST_SLOTS);
}
