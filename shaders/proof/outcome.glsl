// The state of a ray's proof: Proof of src/render/proofs.h.
const int PROOF_UNFINISHED = -1;
const int PROOF_NONE = 0;      // the march ended with neither a root nor a miss
const int PROOF_HIT = 1;
const int PROOF_MISS = 2;
const int PROOF_HIDDEN = 3;    // a root may lie before the one found, or on a ray without one
const int PROOF_SIGN = 4;      // F may not change its sign at the root, or more than once
const int PROOF_BUDGET = 5;
const int PROOF_UNBOUNDED = 6; // F or its slope has no bound somewhere

// The progress of a ray's proof. A texel keeps it between passes.
struct ProofState {
    float settled; // nothing is left to prove from here to the end of the ray's part
    float value;   // F there is at least this far from 0, with this sign; 0: unknown. At the root:
                   // how large F can be
    float piece;   // length of the next piece
    int outcome;
    bool at_root;  // the next piece, or the last one, is about the root
    int pieces;    // number so far; forgotten when the proof ends
};

vec4 packed_proof(ProofState s) {
    float first = s.outcome == PROOF_UNFINISHED ? -1.0 - float(s.pieces) : float(s.outcome);
    return vec4(first, s.settled, s.value, s.at_root ? -s.piece : s.piece);
}

ProofState unpacked_proof(vec4 kept) {
    bool goes_on = kept.x < 0.0;
    return ProofState(kept.y, kept.z, abs(kept.w), goes_on ? PROOF_UNFINISHED : int(kept.x),
                      kept.w < 0.0, goes_on ? int(-kept.x) - 1 : 0);
}
