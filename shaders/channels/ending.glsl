// Where on its ray a hit is, for its proof.
layout(location = ENDING_LOCATION) out float ending_out;

void write_ending(Ray ray, Hit hit, bool on_surface) {
    ending_out = hit.t;
}
