// Opens the depth gate for rays whose proofs are to go on, and closes it for all others. Of rays whose
// blocks are decided nothing is kept.
uniform int start; // as in proof.frag
uniform sampler2D block_texture;

void main() {
    int outcome = load_proof().outcome;
    float of_block = IM_TEXEL(block_texture, ivec2(pixel_centre) / PROVED_BLOCK).w;
    bool goes_on = start == 1 ? outcome >= PROOF_HIDDEN : outcome == PROOF_UNFINISHED;
    bool is_decided = of_block == BLOCK_MISSES || of_block == BLOCK_HITS;
    gl_FragDepth = goes_on && !is_decided ? 1.0 : 0.0;
}
