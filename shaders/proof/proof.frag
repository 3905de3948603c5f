// One pass of the proofs of rays that were marched to their ends.
uniform sampler2D proof_texture_0;
uniform sampler2D proof_texture_1;
// 0: go on; 1: begin; 2: begin anew where closer bounds may help; 3: resume where doubles may help
uniform int start;

layout(location = 0) out vec4 proof_0; // outcome, t of what is settled; the rest for the next pass
layout(location = 1) out vec4 proof_1;

ProofState load_proof() {
    vec4 a = texelFetch(proof_texture_0, ivec2(pixel_centre), 0);
    vec4 b = texelFetch(proof_texture_1, ivec2(pixel_centre), 0);
    return ProofState(a.y, a.z, a.w, int(a.x), b.x != 0.0, int(b.y));
}

void main() {
    RayState ended = load_state();
    bool hit = ended.verdict == VERDICT_HIT;
    Ray marched = pixel_ray();
    enter_beam(marched);
    bool empty = !(marched.t_near <= marched.t_far);
    marched.t_near -= tube.z;
    marched.t_far += tube.z;
    ProofRay ray = proof_ray(marched);
    ProofState s = load_proof();
    if (start == 1 || start == 2 && (s.outcome == PROOF_SIGN || s.outcome == PROOF_HIDDEN)) {
        s = begin_proof(ray, hit, ended.low);
        if (empty) s.outcome = hit ? PROOF_SIGN : PROOF_MISS;
        if (!hit && ended.verdict != VERDICT_MISS) s.outcome = PROOF_NONE;
    }
    if (start == 3 && s.outcome >= PROOF_HIDDEN && !empty) s = resume_proof(s, ray);
    int turns = s.outcome == PROOF_UNFINISHED ? pieces_per_pass : 0;
    if (turns > 0) {
        do {
            s = prove_piece(s, ray, hit);
            turns -= 1;
        } while (turns > 0 && s.outcome == PROOF_UNFINISHED);
    }
    proof_0 = vec4(float(s.outcome), s.settled, toward_zero(s.value), s.piece);
    proof_1 = vec4(float(s.at_root), float(s.pieces), 0.0, 0.0);
}
