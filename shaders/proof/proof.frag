// One pass of the proofs of single rays.
uniform int start; // 0: go on; 1: where no more could be proved, with closer bounds

layout(location = 0) out vec4 proof;

void main() {
    bool hit = load_ending(ivec2(pixel_centre)).hit;
    Ray ray = ray_to_prove();
    ProofState s = load_proof();
    if (start == 1 && s.outcome == PROOF_HIDDEN) {
        s.piece = max(4.0 * s.piece, shortest_piece);
        s.outcome = PROOF_UNFINISHED;
    }
    // A query on this draw tells whether there was anything left to do.
    if (s.outcome != PROOF_UNFINISHED) discard;
    int turns = pieces_per_pass;
    do {
        s = prove_piece(s, ray, hit);
        turns -= 1;
    } while (turns > 0 && s.outcome == PROOF_UNFINISHED);
    proof = packed_proof(s);
}
