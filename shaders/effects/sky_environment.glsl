// The environment behind the surface. Needs effects/environment.glsl.
vec4 sky(vec3 direction) {
    return vec4(environment(direction), 1.0);
}
