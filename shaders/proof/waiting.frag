// Opens the gate for rays whose proofs go on, or are tried again.
uniform int start; // as in proof.frag

void main() {
    int outcome = load_proof().outcome;
    bool waits = start == 0 ? outcome == PROOF_UNFINISHED
                            : outcome == PROOF_SIGN || outcome == PROOF_HIDDEN;
    if (!waits) discard;
    gl_FragDepth = 1.0;
}
