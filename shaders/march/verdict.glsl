// How a ray ends: Verdict of src/render/renderer.h.
const int VERDICT_MISS = 0;
const int VERDICT_HIT = 1;
const int VERDICT_STEP_LIMIT = 2;
const int VERDICT_NAN = 3;
const int VERDICT_ZERO_GRADIENT = 4;
