// Copies the elements that matter in the blocks of a level of beams, as its bits tell, to lists that
// rays and smaller beams go through: copies.glsl says where. Bit e stands for element e of the list
// that the level's beams went through.

layout(location = 0) out vec4 copied;

uniform usampler2DArray beam_masks_texture;

#if LEVEL > 0
// The lists of later levels are made from one of the larger beam's lists. The smallest beams have no
// more than a front; their lists are made from the one that reaches to its end. See
// beam_by_intervals.glsl.
uniform sampler2D beam_texture;

void enter_parent(ivec2 block, vec2 at) {
    vec4 part = textureLod(beam_texture, at, 0.0);
    int which = LISTS_OF_A_BLOCK == 1 && part.z <= part.w ? 0 : 1;
    enter_list(list_of_larger(block * BLOCK / LARGER_BLOCK, which));
}
#else
// Lists of the first level are made from all elements, and are the first in the texture.
const ivec3 list_rows = ivec3(0);

void enter_parent(ivec2 block, vec2 at) {}
#endif

// How many bits of each word are set; ES 3.00 has no bitCount().
uvec4 bits_in(uvec4 words) {
    words -= (words >> 1) & 0x55555555u;
    words = (words & 0x33333333u) + ((words >> 2) & 0x33333333u);
    words = (words + (words >> 4)) & 0x0f0f0f0fu;
    return (words * 0x01010101u) >> 24;
}

// The place of the k-th bit of a word, from 0 on.
int place_of_bit(uint word, int k) {
    int place = 0;
    for (int half_size = 16; half_size > 0; half_size >>= 1) {
        int below = int(bits_in(uvec4(word & ((1u << uint(half_size)) - 1u))).x);
        if (k >= below) {
            k -= below;
            word >>= uint(half_size);
            place += half_size;
        }
    }
    return place;
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy) - ivec2(0, list_rows[LEVEL]);
    const int rows = SLOTS / 16 * TEXELS;
    int list = at.x >> 4, which = list % LISTS_OF_A_BLOCK;
    ivec2 block = ivec2(list / LISTS_OF_A_BLOCK, at.y / rows);
    int row = at.y - block.y * rows;
    int slot = 16 * (row / TEXELS) + (at.x & 15), texel = row % TEXELS;
    int count = 0, before = 0, place = 0;
    vec2 beam_at = (vec2(beam_texel(block, SQUARE_BITS)) + 0.5) / vec2(textureSize(beam_masks_texture, 0).xy);
    uint found = 0u;
    for (int k = 0; k < MASK_TEXELS; ++k) {
        uvec4 words = textureLod(beam_masks_texture, vec3(beam_at, which * MASK_TEXELS + k), 0.0);
        ivec4 ends = ivec4(bits_in(words)); // of the words' elements in the list
        ends.yw += ends.xz;
        ends.zw += ends.yy;
        ends += count;
        ivec4 begins = ivec4(count, ends.xyz);
        for (int word = 0; word < 4; ++word) {
            if (begins[word] <= slot && slot < ends[word]) {
                found = words[word];
                before = begins[word];
                place = 128 * k + 32 * word;
            }
        }
        count = ends.w;
    }
    if (slot == SLOTS - 1) {
        copied = vec4(count < SLOTS ? count : -1);
        return;
    }
    copied = vec4(0.0);
    if (found == 0u) return;
    enter_parent(block, beam_at);
    copied = array0_texel(place + place_of_bit(found, slot - before), texel);
}
