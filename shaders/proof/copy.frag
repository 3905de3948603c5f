// Copies the proofs that went on back to the texture of all proofs.
layout(location = 0) out vec4 proof;

void main() {
    proof = packed_proof(load_proof());
}
