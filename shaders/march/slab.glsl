// The slab of a settled block, which holds the first root of each ray, and no other root. Needs
// beam_place.glsl.

#ifndef TRIMMED
// What beams by models tell of roots: of a settled block the slab, of any other one in .x the tau
// before which there are none. See beam_by_models.glsl.
uniform sampler2D beam_roots_texture;
#endif

// In tau: its middle, how far it leans to the outer pixels, half its thickness; 0 if the block is not settled.
vec4 slab_of(ivec2 block, int bits) {
    return IM_TEXEL(beam_roots_texture, beam_texel(block, bits));
}

// Its middle on the ray of a pixel, which is counted from the block's corner; `side`: of the block.
float middle_of_slab(vec4 slab, vec2 pixel, int side) {
    precise float middle = slab.x + dot(slab.yz, pixel * (2.0 / float(side - 1)) - 1.0);
    return middle;
}
