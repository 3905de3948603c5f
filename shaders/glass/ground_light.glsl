// Shades the ground seen through glass and in it. Needs light_at(), light_from_everywhere() and
// arrives().
uniform vec4 ground_color;

vec3 ground_light(vec3 position, vec3 normal) {
    vec3 sum = light_from_everywhere(normal);
    for (int k = 0; k < LIGHTS; ++k) {
        LightRay light = light_at(k, position);
        sum += light.strength * (max(dot(normal, light.direction), 0.0) * arrives(k));
    }
    return ground_color.rgb * sum;
}
