// One colour behind the surface. Needs shade/shading.glsl.
vec4 sky(vec3 direction) {
    return background;
}
