// Proofs that went on, back to where all are kept.
layout(location = 0) out vec4 proof;

void main() {
    proof = packed_proof(load_proof());
}
