// Places the results of a level of beams in its texture. Software renderers give each square of
// 64 x 64 texels to one of their threads, and a level has few texels. So squares of 2^bits blocks
// are placed apart, one in the corner of each such square.

ivec2 beam_texel(ivec2 block, int bits) {
    return block + (block >> bits) * (SQUARES_APART - (1 << bits));
}

ivec2 beam_block(ivec2 texel, int bits) {
    ivec2 square = texel / SQUARES_APART;
    return texel - square * (SQUARES_APART - (1 << bits));
}
