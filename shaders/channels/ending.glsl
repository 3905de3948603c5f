// Channel ending, for proofs: t of a hit, or a code of verdict.glsl for a miss or an unknown end.
layout(location = ENDING_LOCATION) out float ending_out;

void write_ending(Ray ray, Hit hit, int verdict) {
    ending_out = on_surface(verdict) ? hit.t : verdict == VERDICT_MISS ? ENDS_NOWHERE : ENDS_UNKNOWN;
}
