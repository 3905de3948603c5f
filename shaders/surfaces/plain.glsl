// Shading of one surface among several that calls for no more than shade/lambert.glsl.
vec3 shade(Ray ray, SurfacePoint p, Hit hit) {
    return shade(hit);
}

uvec3 further_record(SurfacePoint p) {
    return uvec3(0u);
}
