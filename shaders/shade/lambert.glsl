// Diffuse light from every directional light, and a little ambient light.
vec3 shade(Hit hit) {
    vec3 light = vec3(0.12);
    for (int k = 0; k < LIGHTS; ++k) {
        light += light_color[k].rgb * max(dot(hit.normal, light_direction[k].xyz), 0.0);
    }
    return surface_color(hit) * light;
}

#if defined(SURFACE) && !defined(DRAWS_AT_ONCE)
// One surface among several that calls for no more.
vec3 shade(Ray ray, SurfacePoint p, Hit hit) {
    return shade(hit);
}

uvec3 further_record(SurfacePoint p) {
    return uvec3(0u);
}
#endif
