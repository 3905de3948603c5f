// Closes the gate to rays with nothing more to prove.
void main() {
    int outcome = load_proof().outcome;
    if (outcome != PROOF_HIT && outcome != PROOF_MISS && outcome != PROOF_NONE) discard;
}
