// The gradient that the march left in the state: march/gradient_at_root.glsl.
vec3 surface_gradient(RayState s, vec3 position) {
    return vec3(s.f_low, s.high);
}
