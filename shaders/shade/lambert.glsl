// Diffuse light from every directional light, and a little ambient light.
vec3 shade(Hit hit) {
    vec3 light = vec3(0.12);
    for (int k = 0; k < LIGHTS; ++k) {
        light += light_color[k].rgb * max(dot(hit.normal, light_direction[k].xyz), 0.0);
    }
    return surface_color(hit) * light;
}
