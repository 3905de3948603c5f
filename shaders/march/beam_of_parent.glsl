// Beams within larger ones, which are PARENT_BLOCK pixels across.
uniform sampler2D beam_texture;
#ifdef LISTS
uniform sampler2D beam_lists_texture;
#endif

// The part of tau, and the first piece to try.
vec4 parent_part(ivec2 block) {
    ivec2 at = beam_texel(block * BLOCK / PARENT_BLOCK, PARENT_SQUARE_BITS);
#ifdef LISTS
    enter_list(texelFetch(beam_lists_texture, at, 0).zw);
#endif
    return vec4(texelFetch(beam_texture, at, 0).xy, 2.0 * beam.z, 0.0);
}
