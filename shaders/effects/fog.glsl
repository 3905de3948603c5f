// Fades with the distance from the eye.
uniform vec4 fog_color;
uniform vec4 fog; // density, start, world units a formula unit

vec3 in_fog(vec3 color, float way) {
    float thick = max(way * fog.z - fog.y, 0.0) * fog.x;
    return mix(fog_color.rgb, color, exp(-thick));
}
