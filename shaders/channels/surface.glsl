// Channel surface: number of the surface that is seen, from 1 on; 0 elsewhere.
layout(location = SURFACE_LOCATION) out vec4 surface_out;

void write_surface(Ray ray, Hit hit, int verdict) {
    surface_out = vec4(on_surface(verdict) ? float(SURFACE_NUMBER) : 0.0, 0.0, 0.0, 0.0);
}
