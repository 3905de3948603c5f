// Lists of the first level are made from all elements.
void enter_parent(ivec2 block, vec2 at) {}
