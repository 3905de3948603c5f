// Lights far away, or (w = 1) at a place; light_color.w is the distance at which a light has its
// colour and beyond which it fades with the square, 0 if it doesn't. Close to a light the factor
// stays below 1e12, so that its light is a float.
LightRay light_at(int k, vec3 position) {
    vec4 place = light_direction[k];
    vec4 color = light_color[k];
    if (place.w == 0.0) return LightRay(place.xyz, 1.0e30, color.rgb);
    vec3 way = place.xyz - position;
    float reach = max(length(way), 1.0e-30);
    float fade = color.w > 0.0 ? min(color.w / reach, 1.0e6) : 1.0;
    return LightRay(way / reach, reach, color.rgb * fade * fade);
}
