// Of proofs whose elements are found by place, see elements/rest.glsl.
#ifdef GRID
#define HAS_ELEMENTS_LEFT (float(grid_entered) < most_elements_of_pass)
// Slopes lead over two boxes at most.
#define KEPT_BY_SLOPES 0.0
#else
#define HAS_ELEMENTS_LEFT true
#define KEPT_BY_SLOPES kept
#endif
