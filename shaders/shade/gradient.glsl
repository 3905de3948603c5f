// The gradient of F at a root, and that of the solid that sections leave.

vec3 matter_gradient(RayState s, vec3 position) {
#ifdef MARCH_TAKES_GRADIENT
    return vec3(s.f_low, s.high); // which the march left in the state: march/at_root.glsl
#else
    return field_gradient(position);
#endif
}

// Outwards.
vec3 surface_gradient(RayState s, vec3 position) {
    vec3 of_matter = matter_gradient(s, position);
#ifdef SECTIONS
    int cap = cap_of(s);
    return cap >= 0 ? section_gradient(cap, position) : of_matter;
#else
    return of_matter;
#endif
}
