// The rounding of a point and of a direction, in each coordinate; the rounding of the ends of the
// part in the bounds; the largest distance of a proved root from the one found.
uniform vec4 tube;
#define BOUNDS_ROUNDING tube.z

// What the proof of a block tells of all its rays, instead of the least slope: src/render/proofs.h.
const float BLOCK_MISSES = -1.0; // none of them hits
const float BLOCK_HITS = -2.0;   // the hits of all of them are proved

// What loops over elements in cells leave: see bounds_of_rest() of elements/cells.glsl.
#ifdef GRID
#define HAS_ELEMENTS_LEFT (grid_entered + grid_others < MOST_ELEMENTS)
// Slopes may lead over two boxes at most.
#define KEPT_BY_SLOPES 0.0
#else
#define HAS_ELEMENTS_LEFT true
#define KEPT_BY_SLOPES kept
#endif
