// Proofs in floats go along the ray that is marched.
#define ProofRay Ray

ProofRay proof_ray(Ray marched) {
    return marched;
}

float toward_zero(float x) {
    return x;
}
