// Fades a colour into fog with the distance from the eye.
uniform vec4 fog_color;
uniform vec4 fog; // density, start, world units per formula unit

vec3 in_fog(vec3 color, float way) {
    float thick = min(max(min(way * fog.z, 1.0e30) - fog.y, 0.0) * fog.x, 200.0); // exp(-200) is 0
    return mix(fog_color.rgb, color, exp(-thick));
}
