// The light of one source at a point.
struct LightRay {
    vec3 direction; // to the light, unit length
    float reach;    // its distance
    vec3 strength;
};

#ifdef NEAR_LIGHTS
// Directional lights, and lights at a point (w = 1). light_color.w is the distance at which a light
// has its colour and beyond which it fades with the square; 0 if it doesn't fade. The factor stays
// below 1e12 close to a light, so that its strength fits a float.
LightRay light_at(int k, vec3 position) {
    vec4 place = light_direction[k];
    vec4 color = light_color[k];
    if (place.w == 0.0) return LightRay(place.xyz, 1.0e30, color.rgb);
    vec3 way = place.xyz - position;
    float reach = max(length(way), 1.0e-30);
    float fade = color.w > 0.0 ? min(color.w / reach, 1.0e6) : 1.0;
    return LightRay(way / reach, reach, color.rgb * fade * fade);
}
#else
// Directional lights. Needs shade/shading.glsl.
LightRay light_at(int k, vec3 position) {
    return LightRay(light_direction[k].xyz, 1.0e30, light_color[k].rgb);
}
#endif
