// Finds where a ray meets the ground.
uniform vec4 ground_plane; // see effects/ground.glsl

vec3 ground_normal(vec3 direction) {
    return dot(ground_plane.xyz, direction) > 0.0 ? -ground_plane.xyz : ground_plane.xyz;
}

// Distance to the ground; 0 or less if the ray does not meet it.
float ground_ahead(vec3 position, vec3 direction) {
    float slope = dot(ground_plane.xyz, direction);
    return slope == 0.0 ? -1.0 : -(dot(ground_plane.xyz, position) + ground_plane.w) / slope;
}
