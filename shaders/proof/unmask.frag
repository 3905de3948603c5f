// Closes the depth gate for rays with nothing left to prove.
void main() {
    int outcome = load_proof().outcome;
    if (outcome != PROOF_HIT && outcome != PROOF_MISS && outcome != PROOF_NONE) discard;
}
