// The endings of a ray: Verdict of src/render/record.h.
const int VERDICT_MISS = 0;
const int VERDICT_HIT = 1;
const int VERDICT_STEP_LIMIT = 2;
const int VERDICT_NAN = 3;
const int VERDICT_ZERO_GRADIENT = 4;

bool on_surface(int verdict) {
    return verdict == VERDICT_HIT || verdict == VERDICT_ZERO_GRADIENT;
}

// Codes of the channel ending for rays without a root.
const float ENDS_NOWHERE = 1.0e30; // a miss
const float ENDS_UNKNOWN = -1.0e30;
