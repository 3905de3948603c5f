// Where rays meet the ground, and how that is lit as it is seen through glass and in it.
#ifdef GROUND
uniform vec4 ground_plane; // see effects/end_of_ray.glsl

vec3 ground_normal(vec3 direction) {
    return dot(ground_plane.xyz, direction) > 0.0 ? -ground_plane.xyz : ground_plane.xyz;
}

// Distance to the ground; 0 or less if the ray does not meet it.
float ground_ahead(vec3 position, vec3 direction) {
    float slope = dot(ground_plane.xyz, direction);
    return slope == 0.0 ? -1.0 : -(dot(ground_plane.xyz, position) + ground_plane.w) / slope;
}

#ifdef LIGHTS
#ifndef GLASS_SHADOWS
// No shadow rays go from here.
float arrives(int k) {
    return 1.0;
}
#endif

vec3 light_from_everywhere(vec3 normal) {
#ifdef AMBIENT
    return ambient(normal);
#else
    return vec3(0.12);
#endif
}

uniform vec4 ground_color;

vec3 ground_light(vec3 position, vec3 normal) {
    vec3 sum = light_from_everywhere(normal);
    for (int k = 0; k < LIGHTS; ++k) {
        LightRay light = light_at(k, position);
        sum += light.strength * (max(dot(normal, light.direction), 0.0) * arrives(k));
    }
    return ground_color.rgb * sum;
}
#endif
#else
float ground_ahead(vec3 position, vec3 direction) {
    return -1.0;
}
#endif
