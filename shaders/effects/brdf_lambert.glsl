// A matt surface: as much light to every side. Needs no other file, has no uniform.
//
// The files brdf_*.glsl define the same two functions; one of them is taken in. Every direction is
// a unit vector away from the surface. Colours of lights are irradiance / pi, so `reflected` is
// pi * brdf * cosine: what goes to the viewer, in units of the light's colour. It is finite and not
// negative wherever light and viewer stand, and 0 for a light that stands below the horizon.
// `mirror_weight` is how much of a mirror's image the material shows, 0..1.

vec3 reflected(vec3 albedo, vec3 normal, vec3 to_viewer, vec3 to_light) {
    return albedo * max(dot(normal, to_light), 0.0);
}

// What a clear coat mirrors, by Schlick.
vec3 mirror_weight(vec3 albedo, vec3 normal, vec3 to_viewer) {
    float c = 1.0 - clamp(dot(normal, to_viewer), 0.0, 1.0);
    return vec3(0.04 + 0.96 * c * c * c * c * c);
}
