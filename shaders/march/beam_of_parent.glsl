// Beams within larger ones, which are PARENT_BLOCK pixels across.
uniform sampler2D beam_texture;
#ifdef LISTS
uniform sampler2D beam_lists_texture;
uniform sampler2D beam_all_texture;
#endif

Part parent_part(ivec2 block) {
    ivec2 at = beam_texel(block * BLOCK / PARENT_BLOCK, PARENT_SQUARE_BITS);
    vec4 part = texelFetch(beam_texture, at, 0);
#ifdef LISTS
    vec2 front = texelFetch(beam_lists_texture, at, 0).xy;
    vec2 all = texelFetch(beam_all_texture, at, 0).xy;
    return Part(part.x, part.y, 2.0 * beam.z, part.z, front, all);
#else
    return Part(part.x, part.y, 2.0 * beam.z);
#endif
}
