// Elements that matter, as bits: element e is bit e & 31 of word e >> 5. In GLSL ES, where shaders can
// write no lists, beams find them so, and march/copy_lists.frag makes lists of them.
struct Mask {
    uvec4 texels[MASK_TEXELS];
};
