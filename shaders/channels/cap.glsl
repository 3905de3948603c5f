// Channel cap: number of the section whose cap is seen, from 1 on; 0 elsewhere.
layout(location = CAP_LOCATION) out vec4 cap_out;

void write_cap(Ray ray, Hit hit, int verdict) {
    cap_out = vec4(on_surface(verdict) ? float(hit.cap + 1) : 0.0, 0.0, 0.0, 0.0);
}
