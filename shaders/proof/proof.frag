// One pass of the proofs of rays that were marched to their ends.
uniform int start; // 0: go on; 1: begin

layout(location = 0) out vec4 proof;

vec4 kept(ProofState s) {
    float first = s.outcome == PROOF_UNFINISHED ? -1.0 - float(2 * s.pieces + int(s.at_root))
                                                : float(s.outcome);
    return vec4(first, s.settled, s.value, s.piece);
}

ProofState proof_of(vec4 kept) {
    int going_on = int(-kept.x) - 1;
    return ProofState(kept.y, kept.z, kept.w, proof_outcome(kept), (going_on & 1) != 0,
                      going_on >> 1);
}

void main() {
    Ending ended = load_ending();
    Ray ray = pixel_ray();
    enter_beam(ray);
    bool empty = !(ray.t_near <= ray.t_far);
    ray.t_near -= tube.z;
    ray.t_far += tube.z;
    ProofState s = proof_of(load_proof());
    if (start == 1) {
        s = begin_proof(ray, ended.hit, ended.t);
        if (empty) s.outcome = ended.hit ? PROOF_SIGN : PROOF_MISS;
        if (!ended.hit && !ended.miss) s.outcome = PROOF_NONE;
    }
    int turns = s.outcome == PROOF_UNFINISHED ? pieces_per_pass : 0;
    if (turns > 0) {
        do {
            s = prove_piece(s, ray, ended.hit);
            turns -= 1;
        } while (turns > 0 && s.outcome == PROOF_UNFINISHED);
    }
    proof = kept(s);
}
