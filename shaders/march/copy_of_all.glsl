// The first level's lists are of all elements.
void enter_parent(ivec2 block) {}
