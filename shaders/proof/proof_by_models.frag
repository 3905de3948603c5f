// One pass of the proofs of single rays, by models.
uniform int start; // 0: continue; 1: resume proofs that were given up

layout(location = 0) out vec4 proof;

void main() {
    bool hit = load_ending(ivec2(pixel_centre)).hit;
    ProofRay ray = proof_ray(ray_to_prove());
    ProofState s = load_proof();
    bool again = start == 1 && s.outcome >= PROOF_HIDDEN && s.settled > ray.t_near;
    if (again) s = resume_proof(s);
    REAL uncertain = uncertain_at_root(s, value_at(ray, s.settled));
    int turns = pieces_per_pass;
    while (turns > 0 && s.outcome == PROOF_UNFINISHED) {
        s = prove_piece(s, ray, hit, uncertain);
        turns -= 1;
    }
    proof = packed_proof(s);
}
