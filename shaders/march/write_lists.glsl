// Writes the lists of beams into a buffer, elements one after the other; each beam has a part of
// it. A list is its number of elements and its first element. `lists` are those of the front and of the middle.

uniform ivec3 list; // this level's first element, limit on one list, blocks across
layout(std430, binding = 0) buffer lists_buffer { vec4 listed[]; };

#define KEPT LIST

struct NewList {
    int first, kept;
};

// Begins list `which` of a block.
NewList new_list(ivec2 block, int which) {
    int place = (block.y * list.z + block.x) * LISTS_OF_A_BLOCK + which;
    return NewList(list.x + place * list.y, 0);
}

void keep(inout NewList made, int e) {
    if (made.kept < list.y) {
        for (int t = 0; t < TEXELS; ++t)
            listed[(made.first + made.kept) * TEXELS + t] = array0_texel(e, t);
    }
    made.kept += 1;
}

// A list that does not fit is replaced by the list that it was made from.
LIST list_of(NewList made) {
    return made.kept <= list.y ? LIST(float(made.kept), float(made.first)) : entered_list();
}

void store_lists(LIST front, LIST middle, LIST all) {
    lists = vec4(front, middle);
    list_of_all = vec4(all, 0.0, 0.0);
}
