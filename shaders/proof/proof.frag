// One pass of the proofs of single rays.
uniform int start; // 0: continue; 1: resume proofs that were given up

layout(location = 0) out vec4 proof;

void main() {
    bool hit = load_ending(ivec2(pixel_centre)).hit;
    Ray marched = ray_to_prove(marched_ray());
    ProofState s = load_proof();
    if (start == 1 && s.outcome >= PROOF_HIDDEN && s.settled > marched.t_near) s = resume_proof(s);
    proof = packed_proof(prove_pieces(s, proof_ray(marched), hit));
}
