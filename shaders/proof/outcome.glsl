// What is proved of a ray: Proof of src/render/proofs.h.
const int PROOF_UNFINISHED = -1;
const int PROOF_NONE = 0;      // the march ended with neither a root nor a miss
const int PROOF_HIT = 1;
const int PROOF_MISS = 2;
const int PROOF_HIDDEN = 3;    // a root may lie before the one found, or where none was
const int PROOF_SIGN = 4;      // F may not change its sign, or more than once, at the root
const int PROOF_BUDGET = 5;
const int PROOF_UNBOUNDED = 6; // F or its slope has no bound somewhere

// Where the proof of a ray stands. It lives in a texel between passes.
struct ProofState {
    float settled; // from here on to the end of the ray's part nothing is left to prove
    float value;   // F there is at least so far from 0, on this side; 0: unknown. At the root: what
                   // F can be there
    float piece;   // the next one's length
    int outcome;
    bool at_root;  // the next piece is about the root, or was the last
    int pieces;    // so far; forgotten when it ends
};

uniform sampler2D proof_texture;

vec4 packed_proof(ProofState s) {
    float first = s.outcome == PROOF_UNFINISHED ? -1.0 - float(s.pieces) : float(s.outcome);
    return vec4(first, s.settled, s.value, s.at_root ? -s.piece : s.piece);
}

ProofState load_proof() {
    vec4 kept = texelFetch(proof_texture, ivec2(pixel_centre), 0);
    bool goes_on = kept.x < 0.0;
    return ProofState(kept.y, kept.z, abs(kept.w), goes_on ? PROOF_UNFINISHED : int(kept.x),
                      kept.w < 0.0, goes_on ? int(-kept.x) - 1 : 0);
}
