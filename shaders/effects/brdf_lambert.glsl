// A matt surface, which reflects equally to every side. Needs no other file and no uniform.
//
// Each file brdf_*.glsl defines the same two functions; a shader contains one of these files.
// Directions are unit vectors away from the surface. Colours of lights are irradiance / pi, so
// `reflected` is pi * brdf * cosine: the light to the viewer, in units of the light's colour. It is
// finite and not negative for any directions, and 0 for a light below the horizon. `mirror_weight`
// is the share of a mirror's image that the material shows, 0..1.

vec3 reflected(vec3 albedo, vec3 normal, vec3 to_viewer, vec3 to_light) {
    return albedo * max(dot(normal, to_light), 0.0);
}

// The share that a clear coat mirrors (Schlick).
vec3 mirror_weight(vec3 albedo, vec3 normal, vec3 to_viewer) {
    float c = 1.0 - clamp(dot(normal, to_viewer), 0.0, 1.0);
    return vec3(0.04 + 0.96 * c * c * c * c * c);
}
