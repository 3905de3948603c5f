// What is proved of a ray: Proof of src/render/proofs.h.
const int PROOF_UNFINISHED = -1;
const int PROOF_NONE = 0;      // the march ended with neither a root nor a miss
const int PROOF_HIT = 1;
const int PROOF_MISS = 2;
const int PROOF_HIDDEN = 3;    // a root may lie before the one found, or where none was
const int PROOF_SIGN = 4;      // F may not change its sign, or more than once, at the root
const int PROOF_BUDGET = 5;
const int PROOF_UNBOUNDED = 6; // F or its slope has no bound somewhere

// What is kept of a proof in a texel: its outcome or, below 0, where it goes on; t of what is
// settled, F there and the next piece.
uniform sampler2D proof_texture;

vec4 load_proof() {
    return texelFetch(proof_texture, ivec2(pixel_centre), 0);
}

int proof_outcome(vec4 kept) {
    return kept.x < 0.0 ? PROOF_UNFINISHED : int(kept.x);
}
