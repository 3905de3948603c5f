// Opens the depth gate for rays that neither their block decided nor, where F is monotone around its
// roots, begin.frag.
uniform sampler2D block_texture;

void main() {
    float of_block = IM_TEXEL(block_texture, ivec2(pixel_centre) / PROVED_BLOCK).w;
    bool is_decided = of_block == BLOCK_MISSES || of_block == BLOCK_HITS;
    bool goes_on = of_block > 0.0 ? load_proof().outcome == PROOF_UNFINISHED : !is_decided;
    gl_FragDepth = goes_on ? 1.0 : 0.0;
}
