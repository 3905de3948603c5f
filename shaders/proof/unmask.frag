// Closes the depth gate for rays whose proofs have ended.
void main() {
    if (load_proof().outcome == PROOF_UNFINISHED) discard;
}
