// Beams within larger ones, which are PARENT_BLOCK pixels across.
uniform sampler2D beam_texture;

Part parent_part(ivec2 block) {
    ivec2 at = beam_texel(block * BLOCK / PARENT_BLOCK, PARENT_SQUARE_BITS);
    vec4 part = texelFetch(beam_texture, at, 0);
#ifdef LISTS
    return Part(part.x, part.y, 2.0 * beam.z, part.z, front_of_beam(at), all_of_beam(at));
#else
    return Part(part.x, part.y, 2.0 * beam.z);
#endif
}
