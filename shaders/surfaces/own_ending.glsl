// channels/ending.glsl where surfaces draw over each other: the place is that on the first one's ray.
layout(location = ENDING_LOCATION) out float ending_out;

void write_ending(Ray ray, Hit hit, int verdict) {
    ending_out = on_surface(verdict)       ? shared_way(ray, hit.t)
                 : verdict == VERDICT_MISS ? ENDS_NOWHERE
                                           : ENDS_UNKNOWN;
}
