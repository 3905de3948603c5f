// What larger beams found to matter in them.

LIST front_of_parent(ivec2 block) { return LIST_OF_LARGER(block, 0); }
LIST all_of_parent(ivec2 block) { return LIST_OF_LARGER(block, 1); }
