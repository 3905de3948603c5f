// Diffuse.
vec3 reflected(vec3 albedo, vec3 normal, vec3 to_viewer, vec3 to_light) {
    return albedo * max(dot(normal, to_light), 0.0);
}

vec3 mirror_weight(vec3 albedo, vec3 normal, vec3 to_viewer) {
    float c = 1.0 - clamp(dot(normal, to_viewer), 0.0, 1.0);
    return vec3(0.04 + 0.96 * c * c * c * c * c);
}
