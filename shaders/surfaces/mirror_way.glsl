// The place on a mirrored ray, which begins at one place for all surfaces.
uniform vec4 surface_way; // lengths of this surface's formula in the first one's

float shared_way(Ray ray, float t) {
    return surface_way.x * t;
}
