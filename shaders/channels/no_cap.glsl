// Channel cap of a scene without sections.
layout(location = CAP_LOCATION) out vec4 cap_out;

void write_cap(Ray ray, Hit hit, int verdict) {
    cap_out = vec4(0.0);
}
