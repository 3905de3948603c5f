// One pass of the proofs of single rays.
uniform bool again; // resumes proofs that were given up

layout(location = 0) out vec4 proof;

void main() {
    Ending ended = load_ending(ivec2(pixel_centre));
    Ray ray = ray_to_prove(marched_ray());
    ProofState s = unpacked_proof(IM_TEXEL(open_texture, texel_of_ray() + ivec2(1, 0)));
    if (again && s.settled > ray.t_near) s = resume_proof(s);
    proof = packed_proof(prove_pieces(s, proof_ray(ray), ended.hit));
}
