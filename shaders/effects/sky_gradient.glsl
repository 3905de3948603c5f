// The sky behind the surface: a colour above and one below. Needs shade/shading.glsl.
//
// Mixed by height on the sphere around, not by angle, which would give a kink at the poles.
uniform vec3 sky_top;
uniform vec3 sky_bottom;

vec4 sky(vec3 direction) {
    // The world's z axis, in formula coordinates.
    vec3 up = normalize(vec3(to_world[0].z, to_world[1].z, to_world[2].z));
    return vec4(mix(sky_bottom, sky_top, 0.5 + 0.5 * dot(up, direction)), 1.0);
}
