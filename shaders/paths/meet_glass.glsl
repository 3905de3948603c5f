// Continues a path where it met the surface of glass: glass/through.glsl, between any two kinds of matter.
uniform sampler2D beyond_texture; // see beyond.frag

// `glass` of glass/refraction.glsl, and `absorbed` of glass/through.glsl, at this place.
vec4 boundary;
int matter_of_ray = NO_MATTER;

vec3 absorbed(float way) {
    return absorbed_in(matter_of_ray, way);
}

int matter_beyond() {
    return int(texelFetch(beyond_texture, ivec2(pixel_centre), 0).x) - 1;
}
