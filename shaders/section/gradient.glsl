// Gradient at the remaining solid's surface, outwards; matter_gradient() is that of F.
vec3 surface_gradient(RayState s, vec3 position) {
    vec3 of_matter = matter_gradient(s, position);
    int cap = cap_of(s);
    return cap >= 0 ? section_gradient(cap, position) : of_matter;
}
