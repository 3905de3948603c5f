// What is proved of a ray: Proof of src/render/proofs.h.
const int PROOF_UNFINISHED = -1;
const int PROOF_NONE = 0;      // the march ended with neither a root nor a miss
const int PROOF_HIT = 1;
const int PROOF_MISS = 2;
const int PROOF_HIDDEN = 3;    // a root may lie before the one found, or where none was
const int PROOF_SIGN = 4;      // F may not change its sign, or more than once, at the root
const int PROOF_BUDGET = 5;
const int PROOF_UNBOUNDED = 6; // F or its slope has no bound somewhere
