// Where beams keep which elements matter in them: bits, see elements/masks.glsl.

layout(location = 1) out uvec4 list_of_front;
layout(location = 2) out uvec4 list_of_middle;
layout(location = 3) out uvec4 list_of_all;

#define NewList LIST

NewList new_list(ivec2 block, int which) { return NewList(0u); }

void keep(inout NewList made, int e) {
    uint bit = 1u << uint(e & 31);
    made |= bit * uvec4(equal(ivec4(e >> 5), ivec4(0, 1, 2, 3)));
}

LIST list_of(NewList made) { return made; }

void store_lists(LIST front, LIST middle, LIST all) {
    list_of_front = front;
    list_of_middle = middle;
    list_of_all = all;
}
