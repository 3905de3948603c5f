// Writes which elements matter in beams, into the layers of a texture at once: MASK_TEXELS for the
// front, and as many for all where LIST_OF_ALL is 1. At the last level
// the list of all of the level before still holds.
layout(location = 1) out uvec4 masks[MASK_TEXELS * LISTS_OF_A_BLOCK];

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
