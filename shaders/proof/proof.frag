// One pass of the proofs of single rays, by bounds.
uniform int start; // 0: continue; 1: resume proofs that were given up

layout(location = 0) out vec4 proof;

void main() {
    bool hit = load_ending(ivec2(pixel_centre)).hit;
    ProofRay ray = proof_ray(ray_to_prove());
    ProofState s = load_proof();
    bool again = start == 1 && s.outcome >= PROOF_HIDDEN && s.settled > ray.t_near;
    if (again) s = resume_proof(s);
    int turns = pieces_per_pass;
    while (turns > 0 && s.outcome == PROOF_UNFINISHED) {
        s = prove_piece(s, ray, hit);
        turns = HAS_ELEMENTS_LEFT ? turns - 1 : 0;
    }
    proof = packed_proof(s);
}
