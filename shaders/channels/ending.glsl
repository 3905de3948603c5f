// Where on its ray a hit is, for its proof; of other endings, which.
layout(location = ENDING_LOCATION) out float ending_out;

void write_ending(Ray ray, Hit hit, int verdict) {
    ending_out = on_surface(verdict) ? hit.t : verdict == VERDICT_MISS ? ENDS_NOWHERE : ENDS_UNKNOWN;
}
