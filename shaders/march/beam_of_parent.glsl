// Beams within larger beams, which are PARENT_BLOCK pixels across.

Part parent_part(ivec2 block) {
    ivec2 at = beam_texel(block * BLOCK / PARENT_BLOCK, PARENT_SQUARE_BITS);
    vec4 part = part_of_beam(at);
#ifdef LISTS
#ifdef COPIES
    ivec2 larger = block * BLOCK / PARENT_BLOCK;
    LIST front = front_of_parent(larger), all = all_of_parent(larger);
#else
    LIST front = front_of_beam(at), all = all_of_beam(at);
#endif
    return Part(part.x, part.y, 2.0 * beam.z, part.z, front, all);
#else
    return Part(part.x, part.y, 2.0 * beam.z);
#endif
}
