// Opens the depth gate for rays whose proofs are to go on, and closes it for all others.
uniform int start; // as in proof.frag

void main() {
    int outcome = load_proof().outcome;
    bool goes_on = start == 1 ? outcome >= PROOF_HIDDEN : outcome == PROOF_UNFINISHED;
    gl_FragDepth = goes_on ? 1.0 : 0.0;
}
