// Proofs in floats use the ray that is marched.
#define ProofRay Ray

ProofRay proof_ray(Ray marched) {
    return marched;
}

float toward_zero(float x) {
    return x;
}

// The t at which a piece is sampled: its beginning. The range of F at the root is known.
const bool SAMPLES_ROOTS = false;
float sampled_at(ProofState s, float low) { return low; }
float uncertain_at_root(ProofState s, vec2 sampled) { return s.value; }
