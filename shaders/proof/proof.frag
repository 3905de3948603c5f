// One pass of the proofs of single rays.
uniform int start; // 0: go on; 1: where no more could be proved, with closer bounds

layout(location = 0) out vec4 proof;

void main() {
    bool hit = load_ending(ivec2(pixel_centre)).hit;
    Ray ray = ray_to_prove();
    ProofState s = load_proof();
    if (start == 1) {
        s.at_root = s.outcome == PROOF_SIGN;
        s.piece = s.at_root ? s.settled - ray.t_near : 4.0 * s.piece;
        s.piece = max(s.piece, shortest_piece);
        s.outcome = PROOF_UNFINISHED;
    }
    int turns = s.outcome == PROOF_UNFINISHED ? pieces_per_pass : 0;
    if (turns > 0) {
        do {
            s = prove_piece(s, ray, hit);
            turns -= 1;
        } while (turns > 0 && s.outcome == PROOF_UNFINISHED);
    }
    proof = packed_proof(s);
}
