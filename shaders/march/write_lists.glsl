#ifdef COPIES
// Writes which elements matter in beams, into the layers of a texture at once: MASK_TEXELS for the
// front, and as many for all where LIST_OF_ALL is 1. At the last level
// the list of all of the level before still holds.
layout(location = 1) out uvec4 masks[MASK_TEXELS * LISTS_OF_A_BLOCK];

// A set of elements as bits: element e is bit e & 31 of word e >> 5. GLSL ES cannot write lists, so
// beams write these bits and copy_lists.frag makes lists of them.
struct Mask {
    uvec4 texels[MASK_TEXELS];
};

#define KEPT Mask
#define NewList Mask

NewList new_list(ivec2 block, int which) { return Mask(uvec4[MASK_TEXELS](TEXELS_OF_NONE)); }

void keep(inout NewList made, int e) {
    uint bit = 1u << uint(e & 31);
    for (int k = 0; k < MASK_TEXELS; ++k) {
        made.texels[k] |= bit * uvec4(equal(ivec4(e >> 5), 4 * k + ivec4(0, 1, 2, 3)));
    }
}

KEPT list_of(NewList made) { return made; }

// Outputs can be written by constant indices only.
void store_masks(KEPT front, KEPT all) {
    masks[0] = front.texels[0];
#if MASK_TEXELS > 1
    masks[1] = front.texels[1];
#endif
#if MASK_TEXELS > 2
    masks[2] = front.texels[2];
#endif
#if LISTS_OF_A_BLOCK == 2
    masks[MASK_TEXELS] = all.texels[0];
#if MASK_TEXELS > 1
    masks[MASK_TEXELS + 1] = all.texels[1];
#endif
#if MASK_TEXELS > 2
    masks[MASK_TEXELS + 2] = all.texels[2];
#endif
#endif
}
#else
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
#endif
