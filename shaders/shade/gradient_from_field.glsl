vec3 surface_gradient(RayState s, vec3 position) {
    return field_gradient(position);
}
