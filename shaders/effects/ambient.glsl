// Ambient light: one colour from the zenith, one from the nadir. Needs shade/shading.glsl.
uniform vec4 ambient_top;
uniform vec4 ambient_bottom;

vec3 ambient(vec3 normal) {
    // The world's z axis, in formula coordinates.
    vec3 up = normalize(vec3(to_world[0].z, to_world[1].z, to_world[2].z));
    return mix(ambient_bottom.rgb, ambient_top.rgb, 0.5 + 0.5 * dot(up, normal));
}
