// What is around the surface: the sky behind it, light from everywhere, fog. Needs shade/shading.glsl, and
// environment.glsl where the sky is a map.

#if defined(SKY_ENVIRONMENT)
vec4 sky(vec3 direction) {
    return vec4(environment(direction), 1.0);
}
#elif defined(SKY_GRADIENT)
// A colour above and one below. Mixed by height on the sphere around, not by angle, which would give a
// kink at the poles.
uniform vec3 sky_top;
uniform vec3 sky_bottom;

vec4 sky(vec3 direction) {
    // The world's z axis, in formula coordinates.
    vec3 up = normalize(vec3(to_world[0].z, to_world[1].z, to_world[2].z));
    return vec4(mix(sky_bottom, sky_top, 0.5 + 0.5 * dot(up, direction)), 1.0);
}
#else
vec4 sky(vec3 direction) {
    return background;
}
#endif

#ifdef AMBIENT
// Ambient light: one colour from the zenith, one from the nadir.
uniform vec4 ambient_top;
uniform vec4 ambient_bottom;

vec3 ambient(vec3 normal) {
    // The world's z axis, in formula coordinates.
    vec3 up = normalize(vec3(to_world[0].z, to_world[1].z, to_world[2].z));
    return mix(ambient_bottom.rgb, ambient_top.rgb, 0.5 + 0.5 * dot(up, normal));
}
#endif

#ifdef FOG
// Fades a colour into fog with the distance from the eye.
uniform vec4 fog_color;
uniform vec4 fog; // density, start, world units per formula unit

vec3 in_fog(vec3 color, float way) {
    float thick = min(max(min(way * fog.z, 1.0e30) - fog.y, 0.0) * fog.x, 200.0); // exp(-200) is 0
    return mix(fog_color.rgb, color, exp(-thick));
}
#endif
