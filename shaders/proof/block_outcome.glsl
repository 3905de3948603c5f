// What the proof of a block tells of all its rays, instead of the least slope: src/render/proofs.h.
const float BLOCK_MISSES = -1.0; // none of them hits
const float BLOCK_HITS = -2.0;   // the hits of all of them are proved
