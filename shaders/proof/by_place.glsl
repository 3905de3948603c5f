// Common part of the proofs with elements in cells; see elements/rest.glsl.
#ifdef GRID
#define HAS_ELEMENTS_LEFT (grid_entered + grid_others < MOST_ELEMENTS)
// Slopes may lead over two boxes at most.
#define KEPT_BY_SLOPES 0.0
#else
#define HAS_ELEMENTS_LEFT true
#define KEPT_BY_SLOPES kept
#endif
