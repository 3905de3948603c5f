// Channel N: unit normal in world coordinates, towards the viewer; 0 where nothing is hit.
layout(location = NORMAL_LOCATION) out vec4 normal_out;

void write_normal(Ray ray, Hit hit, int verdict) {
    vec3 n = normalize(mat3(to_world) * hit.normal);
    normal_out = on_surface(verdict) ? vec4(n, 0.0) : vec4(0.0);
}
