// Directional lights. Needs light.glsl and shade/shading.glsl.
LightRay light_at(int k, vec3 position) {
    return LightRay(light_direction[k].xyz, 1.0e30, light_color[k].rgb);
}
