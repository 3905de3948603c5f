// What proofs share whose elements are found by place; see elements/rest.glsl.
#ifdef GRID
#define HAS_ELEMENTS_LEFT (grid_entered + grid_others < MOST_ELEMENTS)
// Slopes lead over two boxes at most.
#define KEPT_BY_SLOPES 0.0
#else
#define HAS_ELEMENTS_LEFT true
#define KEPT_BY_SLOPES kept
#endif
