// One pass of the proofs of single rays.
uniform int start; // 0: continue; 1: resume proofs that were given up; 2: begin

layout(location = 0) out vec4 proof;

void main() {
    Ending ended = load_ending(ivec2(pixel_centre));
    Ray marched = marched_ray(), ray = ray_to_prove(marched);
    ProofState s = unpacked_proof(IM_TEXEL(open_texture, open_texel() + ivec2(1, 0)));
    if (start == 1 && s.outcome >= PROOF_HIDDEN && s.settled > ray.t_near) s = resume_proof(s);
#ifdef BEGINS
    if (start == 2) s = begun_proof(marched, ray, ended);
#endif
    proof = packed_proof(prove_pieces(s, proof_ray(ray), ended.hit));
}
