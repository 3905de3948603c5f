// A set of elements as bits: element e is bit e & 31 of word e >> 5. GLSL ES cannot write lists, so
// beams write these bits and march/copy_lists.frag makes lists of them.
struct Mask {
    uvec4 texels[MASK_TEXELS];
};
